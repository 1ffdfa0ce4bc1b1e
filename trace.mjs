import { chromium } from "playwright";
import { readFileSync } from "node:fs";
import { createServer } from "node:http";
import { extname, join } from "node:path";
import sharp from "sharp";
const small=await sharp({create:{width:4,height:4,channels:3,background:"#808080"}}).jpeg().toBuffer();
const types={".js":"text/javascript",".html":"text/html",".avif":"image/avif",".wasm":"application/wasm",".json":"application/json",".jpg":"image/jpeg"};
const [look,q,w,h,isSmall,...args]=process.argv.slice(2);
const server=createServer((q,r)=>{ const p=decodeURI(q.url.split("?")[0]);
 if(p==="/room.html"){const u=new URL(q.url,"http://x");r.setHeader("content-type","text/html");r.end(`<!doctype html><style>body{margin:0}candle-flame{width:${u.searchParams.get("w")}px;height:${u.searchParams.get("h")}px;aspect-ratio:auto}</style><candle-flame paused look=${u.searchParams.get("look")} quality=${u.searchParams.get("q")}></candle-flame><script type=module src=/define.js></script>`);return;}
 if(isSmall==="small"&&/\.(avif|jpg)$/.test(p)){r.setHeader("content-type","image/jpeg");r.end(small);return}
 try{const b=readFileSync(join("dist",p));r.setHeader("content-type",types[extname(p)]??"application/octet-stream");r.end(b)}catch{r.statusCode=404;r.end()} }).listen(0);
const port=server.address().port;
const base=["--use-gl=angle","--use-angle=swiftshader","--enable-unsafe-swiftshader","--ignore-gpu-blocklist","--force-color-profile=srgb","--font-render-hinting=none","--disable-lcd-text","--hide-scrollbars","--disable-checker-imaging"];
const browser=await chromium.launch({executablePath:process.env.CHROMIUM_PATH||"/usr/bin/chromium",args:[...base,...args]});
const go=async(page)=>{await page.goto(`http://127.0.0.1:${port}/room.html?look=${look}&q=${q}&w=${w}&h=${h}`);
await page.evaluate(async()=>{const e=document.querySelector("candle-flame");await customElements.whenDefined("candle-flame");await e.ready;e.step(0.1);await e.toBlob()});};
let page=await browser.newPage();await go(page);await page.close();
page=await browser.newPage();
await browser.startTracing(page,{categories:["-*","toplevel","gpu","gpu.angle","disabled-by-default-gpu.service","disabled-by-default-gpu.decoder","blink","v8","devtools.timeline","disabled-by-default-devtools.timeline","disabled-by-default-v8.cpu_profiler","__metadata"]});
const t=Date.now();await go(page);console.log("wall",Date.now()-t);
const buf=await browser.stopTracing();
const {traceEvents}=JSON.parse(buf.toString());
import("node:fs").then(async fs=>{fs.writeFileSync("/tmp/suite/trace.json",buf);
const names={};for(const e of traceEvents)if(e.ph==="M"){names[e.pid+"/"+(e.name==="thread_name"?e.tid:"p")]=e.args.name}
// self time per (proc,thread,name) using X events
const by={};for(const e of traceEvents)if(e.ph==="X"){(by[e.pid+"/"+e.tid]??=[]).push(e)}
const out=[];
for(const [k,evs] of Object.entries(by)){evs.sort((a,b)=>a.ts-b.ts||b.dur-a.dur);const stack=[];const self={};
 for(const e of evs){while(stack.length&&stack.at(-1).end<=e.ts)stack.pop();const use=e.tdur??0;self[e.name]=(self[e.name]??0)+use;if(stack.length)self[stack.at(-1).e.name]-=use;stack.push({e,end:e.ts+e.dur});}
 const [p]=k.split("/");for(const [n,v] of Object.entries(self))out.push([v/1000,names[p+"/p"]+"/"+(names[k]??k),n]);}
out.sort((a,b)=>b[0]-a[0]);for(const o of out.slice(0,32))console.log(o[0].toFixed(0).padStart(6),o[1],o[2]);
// cpu profile
const prof={};for(const e of traceEvents)if(e.name==="ProfileChunk"){const d=e.args.data;const P=prof[e.id]??={nodes:{},self:{}};for(const n of d.cpuProfile?.nodes??[])P.nodes[n.id]={...n.callFrame,parent:n.parent};(d.cpuProfile?.samples??[]).forEach((s,i)=>{P.self[s]=(P.self[s]??0)+(d.timeDeltas?.[i]??0)})}
for(const P of Object.values(prof)){const f={};for(const [id,v] of Object.entries(P.self)){const n=P.nodes[id];if(!n)continue;const key=`${n.functionName} ${(n.url??"").split("/").pop()}:${n.lineNumber}:${n.columnNumber}`;f[key]=(f[key]??0)+v}
 console.log("--profile");for(const [k,v] of Object.entries(f).sort((a,b)=>b[1]-a[1]).slice(0,25))console.log((v/1000).toFixed(0).padStart(6),k)}
await browser.close();process.exit()});
