// Adds a "Copy" button to each prompt, both in lessons (fenced blocks of plain text) and in the output of `%review`.
// JupyterLab loads this plain JavaScript directly, so there's no build step.
(() => {
  const NAME = 'rclpy-workbook-copy';
  const STYLE = new URL('copy.css', document.currentScript.src).href;
  const PROMPTS = '.jp-RenderedMarkdown pre:has(> code.language-text), pre.workbook-copy';
  const COPIED_MS = 2000;

  const addStyle = () => {
    const link = document.createElement('link');
    Object.assign(link, {rel: 'stylesheet', href: STYLE});
    document.head.append(link);
  };

  // The clipboard API needs https or a local server. On other pages, select the text and copy it as a user would.
  const copyByHand = text => {
    const field = document.createElement('textarea');
    Object.assign(field, {value: text, ariaHidden: 'true'});
    document.body.append(field);
    field.select();
    const done = document.execCommand('copy');
    field.remove();
    return done;
  };

  const copy = async text => {
    try {
      await navigator.clipboard.writeText(text);
      return true;
    } catch {
      return copyByHand(text);
    }
  };

  const addButton = prompt => {
    const button = document.createElement('button');
    Object.assign(button, {type: 'button', className: 'wb-copy', textContent: 'Copy'});
    button.setAttribute('aria-live', 'polite');
    button.setAttribute('aria-label', 'Copy the prompt');
    const say = (label, told) => {
      button.textContent = label;
      button.setAttribute('aria-label', told);
    };
    let over = 0;
    button.addEventListener('click', async event => {
      event.stopPropagation();
      const text = prompt.textContent.trim();
      const done = await copy(text);
      say(done ? 'Copied' : 'Select and copy', done ? 'The prompt is copied' : 'Select the prompt and copy it');
      clearTimeout(over);
      over = setTimeout(() => say('Copy', 'Copy the prompt'), COPIED_MS);
      button.focus({preventScroll: true});
    });
    // The button handles Enter and Space, so the notebook must not receive them.
    button.addEventListener('keydown', event => event.stopPropagation());
    const frame = document.createElement('div');
    frame.className = 'wb-prompt';
    prompt.replaceWith(frame);
    frame.append(prompt, button);
  };

  const look = part => {
    for (const prompt of part.querySelectorAll(PROMPTS)) {
      if (!prompt.parentElement.classList.contains('wb-prompt')) {
        addButton(prompt);
      }
    }
  };

  // Search only added nodes, because a moving robot changes the page sixteen times per second.
  const activate = () => {
    addStyle();
    const added = records => new Set(records.flatMap(one => [...one.addedNodes].map(node => node.parentElement)));
    new MutationObserver(records => added(records).forEach(part => part && look(part))).observe(document.body, {
      subtree: true,
      childList: true
    });
    look(document.body);
  };

  const plugin = {id: `${NAME}:plugin`, autoStart: true, activate};
  window._JUPYTERLAB = window._JUPYTERLAB || {};
  window._JUPYTERLAB[NAME] = {
    init: () => {},
    get: async () => () => ({__esModule: true, default: plugin})
  };
})();
