// Functions that our JupyterLab extensions share. JupyterLab loads each extension as a script, which imports this file.

// Load one of JupyterLab's modules. `shared`: all modules that it offers to extensions, each in a single version.
const moduleOf = async (shared, name) => {
  const [version] = Object.values(shared[name] || {});
  if (!version) {
    throw new Error(`this JupyterLab has no ${name}`);
  }
  return (await version.get())();
};

// Build a plugin by calling `make` with the named modules. Return it in the form that JupyterLab expects.
export const pluginWith = async (shared, names, make) => {
  const modules = await Promise.all(names.map(name => moduleOf(shared, name)));
  const plugin = await make(...modules);
  return () => ({__esModule: true, default: plugin});
};
