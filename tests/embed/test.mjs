// npm run test:embed: packs the package as it would be published, installs it into throw-away projects of
// plain HTML, React, Vue, Svelte and a page rendered on a server, checks their types, builds them with Vite
// and opens each in Chromium; and opens a page that has the package from another origin, as from a CDN. Needs a registry for the frameworks; run before a release.
import { execFileSync } from "node:child_process";
import { cpSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { launchSoftwareBrowser, serveBuilt } from "../../tools/built-site.mjs";
import { chosenNames } from "../../tools/chosen-names.mjs";

const VITE = JSON.parse(readFileSync("package.json", "utf8")).devDependencies.vite;
// Checkers of templates need the JavaScript that TypeScript 7 no longer is.
const TYPESCRIPT = "5.9.3";
const REACT = {
  react: "19.3.0",
  "react-dom": "19.3.0",
  "@types/react": "19.3.0",
  "@types/react-dom": "19.3.0",
};

const PROJECTS = [
  { name: "html", needs: {}, checks: [], builds: ["vite build"], loads: 2 },
  { name: "cdn", needs: {}, checks: [], builds: [], loads: 2, serves: serveFromOtherOrigin },
  { name: "react", needs: REACT, checks: ["tsc -p ."], builds: ["vite build"], loads: 1 },
  {
    name: "vue",
    needs: { vue: "3.5.45", "@vitejs/plugin-vue": "6.0.11", "vue-tsc": "3.3.14" },
    checks: ["vue-tsc -p ."],
    builds: ["vite build"],
    loads: 1,
  },
  {
    name: "svelte",
    needs: { svelte: "5.57.3", "@sveltejs/vite-plugin-svelte": "7.3.1", "svelte-check": "4.7.8" },
    checks: ["svelte-check --fail-on-warnings"],
    builds: ["vite build"],
    loads: 1,
  },
  {
    name: "ssr",
    needs: REACT,
    checks: ["tsc -p ."],
    builds: ["vite build", "vite build --ssr server.tsx --outDir server"],
    loads: 1,
  },
  // Types alone: React 18 neither sets properties nor listens.
  {
    name: "react18",
    from: "react",
    needs: { "@types/react": "18.3.8", "@types/react-dom": "18.3.0" },
    checks: ["tsc -p ."],
    builds: [],
    loads: 0,
  },
];

const chosen = chosenNames(PROJECTS.map(({ name }) => name));
const folder = mkdtempSync(join(tmpdir(), "embed-"));
const run = (command, cwd) =>
  execFileSync(command, { cwd, shell: true, stdio: ["ignore", "inherit", "inherit"] });

function install({ name, from = name, needs }, tarball) {
  const cwd = join(folder, name);
  cpSync(resolve("tests/embed", from), cwd, { recursive: true });
  const dependencies = {
    "candle-flame": `file:${tarball}`,
    vite: VITE,
    typescript: TYPESCRIPT,
    ...needs,
  };
  writeFileSync(
    join(cwd, "package.json"),
    JSON.stringify({ name, private: true, type: "module", dependencies }),
  );
  run("npm install --no-audit --no-fund --prefer-offline --loglevel=error", cwd);
  // As docs/embedding.md says: a bundler takes the code, and the files beside it go where the site keeps its own.
  for (const part of ["models", "textures"]) {
    cpSync(
      join(cwd, "node_modules/candle-flame/dist", part),
      join(cwd, "public/candle-flame", part),
      {
        recursive: true,
      },
    );
  }
  return cwd;
}

async function renderOnServer(cwd) {
  const { html } = await import(pathToFileURL(join(cwd, "server/server.js")));
  if (!/<candle-flame[^>]* scene="candle"/.test(html)) throw new Error(`The server wrote ${html}`);
  const file = join(cwd, "dist/index.html");
  writeFileSync(file, readFileSync(file, "utf8").replace("<!--app-->", html));
}

/** A project as built, and everything that it uses beside it. */
async function serveAsBuilt(cwd) {
  const { url, close } = await serveBuilt("dist", { root: cwd });
  const { origin } = new URL(url);
  return { origin, origins: [origin], close };
}

/**
 * A page on one origin, and on another the package as unpkg serves it: its bare name redirects to the file that
 * `package.json` names, and any origin may read it all.
 */
async function serveFromOtherOrigin(cwd) {
  const root = join(cwd, "node_modules/candle-flame");
  const { name, version, unpkg } = JSON.parse(readFileSync(join(root, "package.json"), "utf8"));
  const base = `/${name}@${version}/`;
  const redirect = (_request, response) =>
    response.writeHead(302, { location: join(base, unpkg) }).end();
  const configurePreviewServer = ({ middlewares }) => void middlewares.use(`/${name}`, redirect);
  const cdn = await serveBuilt(".", {
    root,
    base,
    appType: "mpa",
    plugins: [{ name: "redirect", configurePreviewServer }],
    preview: {
      host: "127.0.0.1",
      port: 0,
      cors: { origin: "*" },
      headers: {
        "cross-origin-resource-policy": "cross-origin",
        "x-content-type-options": "nosniff",
      },
    },
  });
  const origins = [cdn.url.slice(0, -1)];
  const page = join(cwd, "index.html");
  writeFileSync(page, readFileSync(page, "utf8").replace("CDN", origins[0]));
  const site = await serveBuilt(".", { root: cwd });
  const close = () => Promise.all([site.close(), cdn.close()]);
  return { origin: site.url, origins: [...origins, new URL(site.url).origin], close };
}

/** What is wrong with the built project as a visitor meets it. */
async function visit(browser, { origin, origins, close }, loads) {
  const page = await browser.newPage();
  const faults = [];
  page.on("pageerror", (error) => faults.push(String(error)));
  page.on("console", (message) => {
    if (message.type() === "error") faults.push(message.text());
  });
  page.on("request", (request) => {
    const { protocol, origin: from } = new URL(request.url());
    if (protocol.startsWith("http") && !origins.includes(from))
      faults.push(`fetched ${request.url()}`);
  });
  page.on("response", (response) => {
    if (response.status() >= 400) faults.push(`${response.status()} ${response.url()}`);
  });
  await page.goto(origin);
  try {
    await page.waitForFunction(() => customElements.get("candle-flame"));
    const found = await page.evaluate(async () => {
      while (!document.querySelector("candle-flame")) await new Promise(requestAnimationFrame);
      const elements = [...document.querySelectorAll("candle-flame")];
      await Promise.all(elements.map(({ ready }) => ready));
      await new Promise((resolve) => setTimeout(resolve));
      const [{ windDirection, stats, lit }] = elements;
      return { windDirection, draws: stats.drawCalls > 0, lit, heard: globalThis.heard };
    });
    const expected = {
      windDirection: 30,
      draws: true,
      lit: true,
      heard: Array(loads).fill("load"),
    };
    if (JSON.stringify(found) !== JSON.stringify(expected))
      faults.push(`found ${JSON.stringify(found)}`);
  } catch (error) {
    faults.push(String(error));
  }
  await page.close();
  await close();
  return faults;
}

const browser = await launchSoftwareBrowser();
let failed = 0;
try {
  mkdirSync(join(folder, "pack"));
  run(`npm pack --loglevel=error --pack-destination "${join(folder, "pack")}"`, ".");
  const [{ filename }] = JSON.parse(
    execFileSync("npm pack --dry-run --ignore-scripts --json --loglevel=error", {
      shell: true,
      encoding: "utf8",
    }),
  );
  const tarball = join(folder, "pack", filename);
  for (const project of PROJECTS) {
    if (!chosen.includes(project.name)) continue;
    let faults = [];
    try {
      const cwd = install(project, tarball);
      for (const command of [...project.checks, ...project.builds]) run(`npx ${command}`, cwd);
      if (project.name === "ssr") await renderOnServer(cwd);
      if (project.loads > 0) {
        const { serves = serveAsBuilt } = project;
        faults = await visit(browser, await serves(cwd), project.loads);
      }
    } catch (error) {
      faults.push(String(error));
    }
    if (faults.length > 0) failed++;
    console.log(`${faults.length === 0 ? "✓" : "✗"} ${project.name}`);
    for (const fault of faults) console.log(`    ${fault}`);
  }
} finally {
  await browser.close();
  if (process.env.KEEP) console.log(folder);
  else rmSync(folder, { recursive: true, force: true });
}
process.exit(failed > 0 ? 1 : 0);
