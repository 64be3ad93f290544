// Typst in a worker of its own, loaded when a PDF is first asked for: sources in, PDF out.
const files = FILES; // put in by the build: {module, wasm, fonts}
const here = new URL("./", self.location.href).href;

async function fetched(name) {
  const answer = await fetch(here + name);
  if (!answer.ok) throw new Error(`${name}: ${answer.status}`);
  return new Uint8Array(await answer.arrayBuffer());
}

async function begun() {
  const { default: load, TypstCompilerBuilder } = await import(here + files.module);
  const [, ...fonts] = await Promise.all([load({ module_or_path: here + files.wasm }), ...files.fonts.map(fetched)]);
  const builder = new TypstCompilerBuilder();
  builder.set_dummy_access_model();
  for (const font of fonts) await builder.add_raw_font(font);
  return builder.build();
}

const compiler = begun();
onmessage = async ({ data: { id, source } }) => {
  try {
    const ready = await compiler;
    ready.add_source("/main.typ", source);
    const { result, diagnostics } = ready.compile("/main.typ", null, "pdf", 3);
    postMessage({ id, pdf: result, error: result ? "" : diagnostics.map((one) => one.message).join("; ") });
  } catch (error) { postMessage({ id, error: String(error?.message ?? error) }); }
};
