import { readFileSync } from "node:fs";
import { readFile } from "node:fs/promises";
import { createServer } from "node:http";
import { extname, join } from "node:path";

const TYPES = {
  ".html": "text/html; charset=utf-8",
  ".js": "text/javascript; charset=utf-8",
  ".json": "application/json",
  ".glb": "model/gltf-binary",
  ".avif": "image/avif",
};

/** Serves what `answer` gives for a path, on a port of its own. */
async function serve(answer) {
  const server = createServer(async ({ url }, response) => {
    try {
      const {
        status = 200,
        headers,
        body,
      } = await answer(new URL(url, "http://localhost").pathname);
      response.writeHead(status, headers).end(body);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  return { origin: `http://127.0.0.1:${server.address().port}`, close: () => server.close() };
}

/**
 * A page on one origin, and on another a package as unpkg serves it: its bare name redirects to the file that
 * `package.json` names, and any origin may read it all.
 */
export async function serveFromCdn(page, root) {
  const { name, version, unpkg } = JSON.parse(readFileSync(join(root, "package.json"), "utf8"));
  const folder = `/${name}@${version}/`;
  const open = {
    "access-control-allow-origin": "*",
    "cross-origin-resource-policy": "cross-origin",
    "x-content-type-options": "nosniff",
  };
  const cdn = await serve(async (path) => {
    if (path === `/${name}`) {
      return { status: 302, headers: { ...open, location: join(folder, unpkg) } };
    }
    if (!path.startsWith(folder)) throw new Error(`${path} is not of the package`);
    const body = await readFile(join(root, path.slice(folder.length)));
    const type = TYPES[extname(path)] ?? "application/octet-stream";
    return { headers: { ...open, "content-type": type }, body };
  });
  const html = readFileSync(page, "utf8").replace("CDN", cdn.origin);
  const site = await serve((path) => {
    if (path !== "/") throw new Error(`the site has no ${path}`);
    return { headers: { "content-type": TYPES[".html"] }, body: html };
  });
  const close = () => {
    site.close();
    cdn.close();
  };
  return { origin: site.origin, cdn: cdn.origin, close };
}
