// Bundles the viewer into crates/io/src/write/report. The first line of the script names a hash over the sources, which a test of
// lineament-io compares, so that a bundle that is not current does not pass.
import { build } from "esbuild";
import { createHash } from "node:crypto";
import { readFileSync, readdirSync, statSync, writeFileSync } from "node:fs";
import { dirname, join, relative, sep } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const out = join(here, "..", "crates", "io", "src", "write", "report");

/** All files below a folder. */
function files(folder) {
  return readdirSync(folder).flatMap((name) => {
    const path = join(folder, name);
    return statSync(path).isDirectory() ? files(path) : [path];
  });
}

/** SHA-256 over the names and contents of the sources, in the order of their names. */
function digest() {
  const names = [...files(join(here, "src")), ...["build.mjs", "package.json", "package-lock.json"].map((n) => join(here, n))];
  const paths = names.map((path) => relative(here, path).split(sep).join("/")).sort();
  const hash = createHash("sha256");
  for (const path of paths) {
    hash.update(`${path}\n`);
    hash.update(readFileSync(join(here, path), "utf8").replaceAll("\r\n", "\n"));
  }
  return hash.digest("hex");
}

const options = { bundle: true, minify: true, write: false, logLevel: "warning", legalComments: "inline" };
const script = await build({
  ...options,
  entryPoints: [join(here, "src", "main.ts")],
  format: "iife",
  target: "es2022",
});
const style = await build({ ...options, entryPoints: [join(here, "src", "style.css")] });
writeFileSync(join(out, "viewer.js"), `// sources ${digest()}\n${script.outputFiles[0].text.trim()}\n`);
writeFileSync(join(out, "viewer.css"), style.outputFiles[0].text.trim() + "\n");
