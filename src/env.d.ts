/// <reference types="vite/client" />

// A shader stage after its includes; `files[n]` is what `#line _ n` refers to.
declare module "*.vert" {
  const shader: { readonly source: string; readonly files: readonly string[] };
  export default shader;
}
declare module "*.frag" {
  const shader: { readonly source: string; readonly files: readonly string[] };
  export default shader;
}
