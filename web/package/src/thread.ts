/**
 * A thread of the pool of thud-threads.wasm (web/wasm/api_threads.c). In browsers this file is the
 * script of a module worker, and stands alone: it imports nothing, so that it can be copied. In
 * Node.js node.ts runs the text of `serveThread` in a worker.
 */

/** What a thread is given. */
export interface ThreadStart {
  /** The compiled thud-threads.wasm, and the memory of the engine, which all threads share. */
  readonly module: WebAssembly.Module;
  readonly memory: WebAssembly.Memory;
  /** The upper end of the thread's stack in that memory, which grows downwards. */
  readonly stack: number;
}

/**
 * Instantiates the module on the engine's memory, calls `begun`, and makes calls of tasks until the
 * engine ends its threads. Refers to nothing outside, since Node.js takes its text.
 */
export function serveThread({ module, memory, stack }: ThreadStart, begun: () => void): void {
  // No task of the engine calls what the module imports: callbacks and the clock.
  const imports: WebAssembly.Imports = {};
  for (const { module: from, name } of WebAssembly.Module.imports(module))
    (imports[from] ??= {})[name] = () => 0;
  imports.env.memory = memory;
  const { exports } = new WebAssembly.Instance(module, imports);
  (exports.__stack_pointer as WebAssembly.Global).value = stack;
  begun();
  (exports.api_thread_serve as () => void)();
}

/** The name of a worker of this script: only a worker of threads.ts has it. */
if ((globalThis as { name?: string }).name === "thud-thread")
  addEventListener("message", ({ data }: MessageEvent<ThreadStart>) => {
    serveThread(data, () => postMessage(null));
    close();
  });
