// CPython as a WebAssembly module, in a worker: its files lie in memory, and each cell is one call.
"use strict";

const BADF = 8, EXIST = 20, INVAL = 28, ISDIR = 31, NOENT = 44, NOSYS = 52, NOTDIR = 54; // errors
const NOTEMPTY = 55, SPIPE = 70;
const DEVICE = 2, FOLDER = 3, FILE = 4; // types of files
const CREATE = 1, ONLY_FOLDER = 2, EXCLUSIVE = 4, TRUNCATE = 8, APPEND = 1; // ways to open them

const fail = (error) => {
  throw error; // a number: the call returns it
};
const encode = (text) => new TextEncoder().encode(text);
/** Nanoseconds of the clock 0, which tells the time of day, or of another. */
const clock = (id) => {
  const since = id === 0 ? performance.timeOrigin : 0;
  return BigInt(Math.round((since + performance.now()) * 1e6));
};

// -- files: a folder has `entries`, a file `bytes`, of which `size` are used, a device `write` ------

let serial = 1n;
const node = (rest) => ({ number: serial++, changed: clock(0), size: 0, ...rest });
const folder = () => node({ entries: new Map() });
const file = (bytes) => node({ bytes, size: bytes.length });
const kind = (node) => (node.entries ? FOLDER : node.bytes ? FILE : DEVICE);
const root = folder();

/** Return what a path leads to, or nothing; fail where its folder is missing. */
function look(from, path) {
  const { entries, name } = parent(from, path);
  return name ? entries.get(name) : from;
}

const find = (from, path) => look(from, path) ?? fail(NOENT);

/** Return the entries of the folder that a path lies in, and the path's last name. */
function parent(from, path) {
  const names = [];
  for (const name of path.split("/")) {
    if (name === "..") names.pop();
    else if (name !== "" && name !== ".") names.push(name);
  }
  const name = names.pop();
  let at = from;
  for (const name of names) at = at.entries?.get(name) ?? fail(at.entries ? NOENT : NOTDIR);
  return { entries: at.entries ?? fail(NOTDIR), name };
}

function put(path, bytes) {
  let at = root;
  const names = path.split("/");
  for (const name of names.slice(0, -1)) {
    if (!at.entries.has(name)) at.entries.set(name, folder());
    at = at.entries.get(name);
  }
  at.entries.set(names.at(-1), file(bytes));
}

function resize(file, size) {
  if (size > file.bytes.length) {
    const grown = new Uint8Array(Math.max(size, 2 * file.bytes.length));
    grown.set(file.bytes.subarray(0, file.size));
    file.bytes = grown;
  }
  file.bytes.fill(0, size, Math.max(size, file.size));
  file.size = size;
  file.changed = clock(0);
}

/** A device that makes text of the bytes that are written to it, line by line if it is told to. */
function output(take, lines = false) {
  const decoder = new TextDecoder();
  let text = "";
  const write = (bytes) => {
    text += decoder.decode(bytes, { stream: true });
    const end = lines ? text.lastIndexOf("\n") + 1 : text.length;
    if (end) take(text.slice(0, end));
    text = text.slice(end);
  };
  return node({ write });
}

const stream = (name) => ({ node: output((text) => postMessage({ name, text })) });
const handles = [{ node: node({}) }, stream("stdout"), stream("stderr"), { node: root, name: "/" }];
const show = (text) => text.trim().split("\n").forEach((line) => postMessage(JSON.parse(line)));
root.entries.set("show", output(show, true)); // what `session.send` writes to

// -- the system calls of WASI: `handle` is what lies behind the number of an open file --------------

let memory; // of the module
const view = () => new DataView(memory.buffer);
const bytesAt = (place, length) => new Uint8Array(memory.buffer, place, length);
const textAt = (place, length) => new TextDecoder().decode(bytesAt(place, length));
const set32 = (place, value) => view().setUint32(place, value, true);
const set64 = (place, value) => view().setBigUint64(place, BigInt(value), true);

/** The pieces of memory that a call reads into or writes from. */
function pieces(list, count) {
  const number = (k) => view().getUint32(list + 4 * k, true);
  return Array.from({ length: count }, (_, k) => bytesAt(number(2 * k), number(2 * k + 1)));
}

function read({ node }, from, list, count, result) {
  if (node.entries) fail(ISDIR);
  let at = from;
  for (const piece of node.bytes ? pieces(list, count) : []) {
    const end = Math.max(at, Math.min(node.size, at + piece.length));
    piece.set(node.bytes.subarray(at, end));
    at = end;
  }
  set32(result, at - from);
  return at;
}

function write({ node }, from, list, count, result) {
  if (node.entries) fail(ISDIR);
  let at = from;
  for (const piece of pieces(list, count)) {
    const end = at + piece.length;
    if (node.write) node.write(piece.slice());
    else {
      resize(node, Math.max(node.size, end));
      node.bytes.set(piece, at);
    }
    at = end;
  }
  set32(result, at - from);
  return at;
}

function describe(node, place) {
  bytesAt(place, 64).fill(0);
  set64(place + 8, node.number);
  set64(place + 16, kind(node));
  set64(place + 24, 1);
  set64(place + 32, node.size);
  for (const time of [40, 48, 56]) set64(place + time, node.changed);
}

/** Make the pair of calls that report texts: how many, with their size, and the texts. */
function texts(...list) {
  const all = list.map((text) => encode(text + "\0"));
  const sizes = (count, size) => {
    set32(count, all.length);
    set32(size, all.reduce((sum, text) => sum + text.length, 0));
  };
  const get = (places, buffer) => {
    for (const [k, text] of all.entries()) {
      set32(places + 4 * k, buffer);
      bytesAt(buffer, text.length).set(text);
      buffer += text.length;
    }
  };
  return [sizes, get];
}

// The second argument is added to `sys.path`.
const [args_sizes_get, args_get] = texts("/usr/local/bin/python.wasm", "/lib");
const [environ_sizes_get, environ_get] = texts("HOME=/home", "TMPDIR=/tmp", "MPLBACKEND=agg",
  "PYTHONTZPATH=", "PYTHONDONTWRITEBYTECODE=1", "PYDY_CACHE_DIR=off");

const calls = {
  args_sizes_get, args_get, environ_sizes_get, environ_get,
  clock_res_get: (id, result) => set64(result, 1000),
  clock_time_get: (id, precision, result) => set64(result, clock(id)),
  random_get: (place, length) => {
    for (let k = 0; k < length; k += 65536) {
      crypto.getRandomValues(bytesAt(place + k, Math.min(65536, length - k)));
    }
  },
  proc_exit: (code) => {
    throw new Error(`Python ended with the code ${code}`);
  },
  sched_yield: () => {},
  /** Sleep until the first of the given times: without threads, nothing else can happen. */
  poll_oneoff: (events, results, count, result) => {
    let wait = Infinity;
    for (let k = 0; k < count; k++) {
      const [at, out] = [events + 48 * k, results + 32 * k];
      const type = view().getUint8(at + 8);
      bytesAt(out, 32).fill(0);
      bytesAt(out, 8).set(bytesAt(at, 8));
      view().setUint8(out + 10, type);
      const isAbsolute = view().getUint16(at + 40, true) & 1;
      const now = isAbsolute ? clock(view().getUint32(at + 16, true)) : 0n;
      if (type === 0) wait = Math.min(wait, Number(view().getBigUint64(at + 24, true) - now));
      else wait = 0;
    }
    const end = performance.now() + wait / 1e6;
    while (performance.now() < end); // a worker of a page that is not isolated cannot wait
    set32(result, count);
  },

  fd_prestat_get: (handle, result) => {
    if (!handle.name) fail(BADF);
    set64(result, BigInt(handle.name.length) << 32n);
  },
  fd_prestat_dir_name: (handle, place, length) => {
    bytesAt(place, length).set(encode(handle.name));
  },
  fd_close: (handle) => delete handles[handles.indexOf(handle)],
  fd_fdstat_get: ({ node, append }, result) => {
    set64(result, kind(node));
    view().setUint16(result + 2, append ? APPEND : 0, true);
    // What cannot be moved in is a terminal.
    const rights = BigInt.asUintN(64, kind(node) === DEVICE ? ~0x24n : ~0n);
    for (const place of [8, 16]) set64(result + place, rights);
  },
  fd_fdstat_set_flags: (handle, flags) => {
    handle.append = flags & APPEND;
  },
  fd_filestat_get: ({ node }, result) => describe(node, result),
  fd_filestat_set_size: ({ node }, size) => resize(node, Number(size)),
  fd_filestat_set_times: () => {},
  path_filestat_set_times: () => {},
  fd_advise: () => {},
  fd_datasync: () => {},
  fd_sync: () => {},
  fd_read: (handle, list, count, result) => {
    handle.at = read(handle, handle.at ?? 0, list, count, result);
  },
  fd_pread: (handle, list, count, at, result) => {
    read(handle, Number(at), list, count, result);
  },
  fd_write: (handle, list, count, result) => {
    const from = handle.append ? handle.node.size : handle.at ?? 0;
    handle.at = write(handle, from, list, count, result);
  },
  fd_pwrite: (handle, list, count, at, result) => {
    write(handle, Number(at), list, count, result);
  },
  fd_seek: (handle, offset, whence, result) => {
    if (!handle.node.bytes) fail(SPIPE);
    const at = Number(offset) + [0, handle.at, handle.node.size][whence];
    if (at < 0) fail(INVAL);
    handle.at = at;
    set64(result, at);
  },
  fd_tell: (handle, result) => calls.fd_seek(handle, 0, 1, result),
  fd_readdir: ({ node }, place, length, cookie, result) => {
    const all = [...(node.entries ?? fail(NOTDIR))];
    let used = 0;
    for (let k = Number(cookie); k < all.length && used < length; k++) {
      const name = encode(all[k][0]);
      const entry = new Uint8Array(24 + name.length);
      const fields = new DataView(entry.buffer);
      fields.setBigUint64(0, BigInt(k + 1), true);
      fields.setBigUint64(8, all[k][1].number, true);
      fields.setUint32(16, name.length, true);
      fields.setUint8(20, kind(all[k][1]));
      entry.set(name, 24);
      const part = entry.subarray(0, length - used);
      bytesAt(place + used, part.length).set(part);
      used += part.length;
    }
    set32(result, used);
  },

  path_open: ({ node }, how, place, length, flags, rights, inherited, state, result) => {
    const path = textAt(place, length);
    let found = look(node, path);
    if (found && flags & EXCLUSIVE) fail(EXIST);
    if (!found) {
      if (!(flags & CREATE)) fail(NOENT);
      found = file(new Uint8Array(0));
      const { entries, name } = parent(node, path);
      entries.set(name, found);
    }
    if (flags & ONLY_FOLDER && !found.entries) fail(NOTDIR);
    if (flags & TRUNCATE && found.bytes) resize(found, 0);
    let number = 4;
    while (handles[number]) number++;
    handles[number] = { node: found, at: 0, append: state & APPEND };
    set32(result, number);
  },
  path_filestat_get: ({ node }, how, place, length, result) => {
    describe(find(node, textAt(place, length)), result);
  },
  path_create_directory: ({ node }, place, length) => {
    const { entries, name } = parent(node, textAt(place, length));
    if (!name || entries.has(name)) fail(EXIST);
    entries.set(name, folder());
  },
  path_unlink_file: ({ node }, place, length) => {
    const path = textAt(place, length);
    if (find(node, path).entries) fail(ISDIR);
    const { entries, name } = parent(node, path);
    entries.delete(name);
  },
  path_remove_directory: ({ node }, place, length) => {
    const path = textAt(place, length);
    if ((find(node, path).entries ?? fail(NOTDIR)).size) fail(NOTEMPTY);
    const { entries, name } = parent(node, path);
    entries.delete(name);
  },
  path_rename: ({ node }, place, length, to, newPlace, newLength) => {
    const found = find(node, textAt(place, length));
    const old = parent(node, textAt(place, length));
    const next = parent(handles[to].node, textAt(newPlace, newLength));
    old.entries.delete(old.name);
    next.entries.set(next.name, found);
  },
};

/** Make a call return its error, and take an open file in place of its number. */
const called = (known, name) => (...given) => {
  try {
    if (/^(fd|path)_/.test(name)) given[0] = handles[given[0]] ?? fail(BADF);
    (known[name] ?? fail(NOSYS))(...given);
    return 0;
  } catch (error) {
    if (typeof error === "number") return error;
    throw error;
  }
};

// -- Python -----------------------------------------------------------------------------------------

let python;

async function fetched(name) {
  const answer = await fetch(name);
  if (!answer.ok) throw new Error(`${name}: ${answer.status} ${answer.statusText}`);
  return new Response(answer.body.pipeThrough(new DecompressionStream("gzip")), {
    headers: { "Content-Type": "application/wasm" },
  });
}

async function start() {
  const [compiled, files] = await Promise.all([
    fetched("python.packed").then((answer) => WebAssembly.compileStreaming(answer)),
    fetched("files.packed").then((answer) => answer.arrayBuffer()),
  ]);
  // The length of a table, the table (path: length), and the files.
  const size = new DataView(files).getUint32(0, true);
  let at = 4 + size;
  const table = JSON.parse(new TextDecoder().decode(new Uint8Array(files, 4, size)));
  for (const [path, length] of Object.entries(table)) {
    put(path, new Uint8Array(files, at, length));
    at += length;
  }
  for (const name of ["home", "tmp"]) root.entries.set(name, folder());
  const instance = await WebAssembly.instantiate(compiled, {
    wasi_snapshot_preview1: new Proxy(calls, { get: called }),
    host: { call: () => -1 },
  });
  python = instance.exports;
  memory = python.memory;
  // The module was saved while it knew another archive of the same name.
  run("__import__('zipimport')._zip_directory_cache.clear()");
  run("__import__('session').prepare()");
}

/** Run an expression of our own, which must not define names beside those of the cells. */
function run(code) {
  const bytes = encode(code);
  const place = python.host_alloc(bytes.length);
  bytesAt(place, bytes.length).set(bytes);
  python.turn(place, bytes.length);
}

const started = start();
started.catch(() => {}); // whoever waits for it hears of it
onmessage = async ({ data }) => {
  try {
    await started;
    const [[name, text]] = Object.entries(data);
    run(`__import__('session').${name}(${JSON.stringify(text)})`);
  } catch (error) {
    const old = error instanceof WebAssembly.CompileError;
    postMessage({ died: `${old ? "This needs a browser of 2025 or later. " : ""}${error}` });
  }
};
