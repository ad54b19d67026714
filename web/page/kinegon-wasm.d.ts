/** What wasm-bindgen makes of `web/engine`. */
declare module "kinegon-wasm" {
  export default function init(from: { module_or_path: WebAssembly.Module }): Promise<unknown>;
  export class Engine {}
}
