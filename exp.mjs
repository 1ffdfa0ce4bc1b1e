import { chromium } from "playwright";
import { readFileSync } from "node:fs";
import { createServer } from "node:http";
import { extname, join } from "node:path";
const types={".js":"text/javascript",".html":"text/html",".avif":"image/avif",".wasm":"application/wasm",".json":"application/json",".jpg":"image/jpeg"};
const server=createServer((q,r)=>{ const p=decodeURI(q.url.split("?")[0]);
 if(p==="/room.html"){const u=new URL(q.url,"http://x");r.setHeader("content-type","text/html");r.end(`<!doctype html><style>body{margin:0}candle-flame{width:${u.searchParams.get("w")}px;height:${u.searchParams.get("h")}px;aspect-ratio:auto}</style><candle-flame paused look=${u.searchParams.get("look")} quality=${u.searchParams.get("q")}></candle-flame><script type=module src=/define.js></script>`);return;}
 try{const b=readFileSync(join("dist",p));r.setHeader("content-type",types[extname(p)]??"application/octet-stream");r.end(b)}catch{r.statusCode=404;r.end()} }).listen(0);
const port=server.address().port;
const [look,q,w,h,n,...args]=process.argv.slice(2);
const base=["--use-gl=angle","--use-angle=swiftshader","--enable-unsafe-swiftshader","--ignore-gpu-blocklist","--force-color-profile=srgb","--font-render-hinting=none","--disable-lcd-text","--hide-scrollbars","--disable-checker-imaging"];
const stat=()=>{const l=readFileSync("/proc/stat","utf8").split("\n")[0].split(/\s+/).slice(1).map(Number);return (l[0]+l[1]+l[2])/100};
const browser=await chromium.launch({executablePath:process.env.CHROMIUM_PATH||"/usr/bin/chromium",args:[...base,...args]});
const {disabled,P}={disabled:process.env.DIS??"",P:0};
for(let i=0;i<+n;i++){
 const t=Date.now(),c=stat();
 const page=await browser.newPage({viewport:{width:640,height:360}});
 await page.goto(`http://127.0.0.1:${port}/room.html?look=${look}&q=${q}&w=${w}&h=${h}`);
 const hash=await page.evaluate(async()=>{const e=document.querySelector("candle-flame");await customElements.whenDefined("candle-flame");await e.ready;window.t0=performance.now(); e.step(0.1);const b=new Uint8Array(await (await e.toBlob()).arrayBuffer());return [...new Uint8Array(await crypto.subtle.digest("SHA-256",b))].slice(0,4).join(".")+" step "+(performance.now()-t0|0)});
 console.log(i,((Date.now()-t)/1000).toFixed(2),"s wall",(stat()-c).toFixed(2),"s cpu",hash);
 await page.close();
}
await browser.close();process.exit();
