declare module "gltf-validator" {
  interface Message {
    /** 0 is an error. */
    readonly severity: number;
    readonly code: string;
    readonly message: string;
    readonly pointer?: string;
  }

  interface Report {
    readonly issues: { readonly numErrors: number; readonly messages: readonly Message[] };
    readonly info: { readonly totalTriangleCount: number };
  }

  interface Options {
    readonly uri?: string;
    readonly externalResourceFunction?: (uri: string) => Promise<Uint8Array>;
  }

  const validator: {
    validateBytes(bytes: Uint8Array, options?: Options): Promise<Report>;
  };
  export default validator;
}
