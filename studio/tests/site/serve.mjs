// A folder over HTTP, as any host of static files has it: `node serve.mjs FOLDER PORT`. Loopback only.
import { createServer } from "node:http";
import { readFile } from "node:fs/promises";
import { extname, join, normalize } from "node:path";

const [folder, port] = process.argv.slice(2);
const TYPES = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".wasm": "application/wasm", ".svg": "image/svg+xml", ".png": "image/png", ".woff2": "font/woff2" };

createServer(async (request, response) => {
  const path = normalize(decodeURIComponent(new URL(request.url ?? "/", "http://localhost").pathname));
  try {
    const bytes = await readFile(join(folder ?? ".", path.endsWith("/") ? join(path, "index.html") : path));
    response.writeHead(200, { "content-type": TYPES[extname(path)] ?? (path.endsWith("/") ? "text/html" : "application/octet-stream") });
    response.end(bytes);
  } catch {
    response.writeHead(404).end();
  }
}).listen(Number(port), "127.0.0.1");
