"use strict";
// Sorts and filters the map of the class. Without this script, the page shows all students, sorted by points.
const table = document.getElementById("students");
const form = document.getElementById("filter");
const rows = [...table.tBodies[0].rows];
const heads = [...table.tHead.rows[0].cells];
const FIRST_CRITERION = 2;
const STATES = ["failed", "partial", "skipped", "passed"];

function sortKey(row, column) {
  const cell = row.cells[column];
  if (column === 0) return cell.textContent;
  if (column === 1) return row.dataset.points === "" ? null : Number(row.dataset.points);
  return cell.className ? STATES.indexOf(cell.className) : null;
}

function compare(one, other) {
  if (one === null || other === null) return (one === null) - (other === null);
  return typeof one === "number" ? one - other : one.localeCompare(other, undefined, { numeric: true });
}

function sortBy(column) {
  const head = heads[column];
  const sign = head.getAttribute("aria-sort") === "ascending" ? -1 : 1;
  heads.forEach((other) => other.removeAttribute("aria-sort"));
  head.setAttribute("aria-sort", sign === 1 ? "ascending" : "descending");
  rows.sort((a, b) => {
    const [one, other] = [sortKey(a, column), sortKey(b, column)];
    const order = compare(one, other);
    return one === null || other === null ? order : sign * order;
  });
  table.tBodies[0].append(...rows);
}

function isAsked(row, show) {
  const [kind, number] = show.split("-");
  const data = row.dataset;
  if (kind === "lost") return data.points !== "" && !("full" in data);
  if (kind === "full" || kind === "twice") return kind in data;
  if (kind === "missing") return data.points === "";
  if (kind === "criterion") {
    return ["failed", "partial"].includes(row.cells[FIRST_CRITERION + Number(number) - 1].className);
  }
  if (kind === "cause") return data.causes.split(" ").includes(number);
  return true;
}

function filter() {
  const name = form.elements.name.value.trim().toLowerCase();
  const show = form.elements.show.value;
  for (const row of rows) {
    row.hidden = !(row.cells[0].textContent.toLowerCase().includes(name) && isAsked(row, show));
  }
  const left = rows.filter((row) => !row.hidden).length;
  form.elements.count.value = `${left} of ${rows.length} students`;
}

heads.forEach((head, column) => {
  if (column >= FIRST_CRITERION && !head.title) return;
  const button = document.createElement("button");
  button.type = "button";
  button.append(...head.childNodes);
  button.addEventListener("click", () => sortBy(column));
  head.append(button);
});
form.addEventListener("input", filter);
form.addEventListener("submit", (event) => event.preventDefault());
for (const link of document.querySelectorAll("[data-show]")) {
  link.addEventListener("click", () => {
    form.elements.name.value = "";
    form.elements.show.value = link.dataset.show;
    filter();
  });
}
form.hidden = false;
filter();
