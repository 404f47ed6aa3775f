// A kernel of JupyterLite that runs cells in worker.js. This file is an extension as JupyterLite
// loads it: a container of module federation, written by hand because it has one module.
"use strict";
{
  const folder = new URL("../../", document.currentScript.src); // of worker.js
  const STOPPED = "Python starts again with the next cell, without what the cells above defined.";
  const startWorker = () => new Worker(new URL("worker.js", folder));
  let first = startWorker(); // Python starts while the notebook is drawn
  let shared;

  const makeKernel = (BaseKernel) =>
    class Kernel extends BaseKernel {
      start() {
        this.worker = first ?? startWorker();
        first = undefined;
        this.worker.onmessage = ({ data }) => this.take(data);
        this.worker.onerror = (event) => this.end("WorkerError", event.message);
      }

      /** Ask the worker, and wait for its answer: none if it ends before. */
      ask(question) {
        if (!this.worker) this.start();
        return new Promise((resolve) => {
          this.answer = resolve;
          this.worker.postMessage(question);
        });
      }

      take({ text, name, ...message }) {
        if (name) this.stream({ name, text });
        if (message.show) this.displayData({ data: message.show, metadata: {} });
        if (message.result) {
          const [data, execution_count] = [message.result, this.executionCount];
          this.publishExecuteResult({ data, metadata: {}, execution_count });
        }
        if (message.error) this.error = message.error;
        if (message.answer !== undefined) this.answered(message.answer);
        if (message.died) this.end("PythonEnded", message.died);
      }

      answered(answer) {
        this.answer?.(answer);
        this.answer = undefined;
      }

      /** End Python, which nothing else can interrupt; the next cell starts it again. */
      end(ename, evalue) {
        this.worker?.terminate();
        this.worker = undefined;
        this.error = { ename, evalue, traceback: [`${ename}: ${evalue}`] };
        this.answered(null);
      }

      stop() {
        if (this.answer) this.end("Stopped", STOPPED);
      }

      async executeRequest({ code }) {
        this.error = undefined;
        await this.ask({ run: code });
        const execution_count = this.executionCount;
        if (!this.error) return { status: "ok", execution_count, user_expressions: {} };
        this.publishExecuteError(this.error);
        return { status: "error", execution_count, ...this.error };
      }

      async completeRequest({ code, cursor_pos }) {
        const found = await this.ask({ complete: code.slice(0, cursor_pos) });
        const [matches, length] = found ?? [[], 0];
        const cursor_start = cursor_pos - length;
        return { status: "ok", matches, cursor_start, cursor_end: cursor_pos, metadata: {} };
      }

      async inspectRequest() {
        return { status: "ok", found: false, data: {}, metadata: {} };
      }

      async isCompleteRequest() {
        return { status: "unknown" };
      }

      async kernelInfoRequest() {
        const language_info = {
          name: "python",
          version: "3.15",
          mimetype: "text/x-python",
          file_extension: ".py",
          codemirror_mode: { name: "python", version: 3 },
        };
        return {
          status: "ok",
          implementation: "pydy",
          implementation_version: "1",
          protocol_version: "5.3",
          banner: "",
          help_links: [],
          language_info,
        };
      }

      async commInfoRequest() {
        return { status: "ok", comms: {} };
      }

      inputReply() {}
      async commOpen() {}
      async commMsg() {}
      async commClose() {}

      dispose() {
        this.worker?.terminate();
        super.dispose();
      }
    };

  const moduleOf = async (name) => {
    const versions = Object.values(shared[name]);
    return (await versions[0].get())();
  };

  async function makePlugin() {
    const { BaseKernel, IKernelClient, IKernelSpecs } = await moduleOf("@jupyterlite/services");
    const Kernel = makeKernel(BaseKernel);
    const kernels = new Map();
    return {
      id: "pydy-kernel:plugin",
      autoStart: true,
      requires: [IKernelSpecs],
      optional: [IKernelClient],
      activate: (app, specs, client) => {
        specs.register({
          spec: {
            name: "python",
            display_name: "Python",
            language: "python",
            argv: [],
            resources: {},
          },
          create: async (options) => {
            const kernel = new Kernel(options);
            kernels.set(options.id, kernel);
            return kernel;
          },
        });
        if (!client) return;
        // JupyterLite itself only calls off the cells that wait.
        const interrupt = client.interrupt.bind(client);
        client.interrupt = async (id) => {
          await interrupt(id);
          kernels.get(id)?.stop();
        };
      },
    };
  }

  window._JUPYTERLAB ??= {};
  window._JUPYTERLAB["pydy-kernel"] = {
    init: (scope) => {
      shared = scope;
    },
    get: async () => {
      const plugin = await makePlugin();
      return () => ({ __esModule: true, default: plugin });
    },
  };
}
