// From the text of the data to the page's object: JSON in which numbers lie as base64 Blobs (typed
// arrays, little-endian) and as Series (deflated second differences). Blobs become typed arrays;
// a run's columns are decoded at their first use, those of forces not before they are asked for.

const TYPES = { f32: Float32Array, f64: Float64Array, u32: Uint32Array };

function bytesOf(base64) {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes;
}

/** {type, n, data} -> typed array of n numbers. */
export function decodeBlob(blob) {
  const Type = TYPES[blob.type];
  if (!Type) throw new Error(`data: blob of unknown type "${blob.type}"`);
  const bytes = bytesOf(blob.data);
  if (bytes.length !== blob.n * Type.BYTES_PER_ELEMENT) {
    throw new Error(`data: a blob of ${blob.n} ${blob.type} has ${bytes.length} bytes`);
  }
  return new Type(bytes.buffer);
}

async function inflate(bytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/**
 * Varints of zigzag second differences -> n values of the unit `scale`. Integers are below 2^53;
 * what lies above 2^28 of a varint is added by multiplication, as bit operations end at 32 bits.
 */
export function undoDifferences(bytes, n, scale) {
  const values = new Float64Array(n);
  // A power of ten below 1 is not a binary number, its inverse is: q/10^k is the CSV's own number.
  const inverse = scale < 1 ? Math.round(1 / scale) : 0;
  let at = 0, last = 0, slope = 0;
  for (let i = 0; i < n; ++i) {
    let byte = bytes[at++], low = byte & 127, shift = 7;
    while (byte > 127 && shift < 28) {
      byte = bytes[at++];
      low |= (byte & 127) << shift;
      shift += 7;
    }
    let zigzag = low, weight = 2 ** 28;
    while (byte > 127) {
      byte = bytes[at++];
      zigzag += (byte & 127) * weight;
      weight *= 128;
    }
    // d = q_i − 2q_{i−1} + q_{i−2} changes the slope q_i − q_{i−1}.
    slope += zigzag % 2 ? -(zigzag + 1) / 2 : zigzag / 2;
    last += slope;
    values[i] = inverse ? last / inverse : last * scale;
  }
  if (at !== bytes.length) throw new Error(`data: a series of ${n} values ends at byte ${at}`);
  return values;
}

/** {n, scale, data} or, if there is a nan among them, {n, values: Blob} -> Float64Array. */
export async function decodeSeries(series) {
  if (series.values) return decodeBlob(series.values);
  return undoDifferences(await inflate(bytesOf(series.data)), series.n, series.scale);
}

function isBlob(value) {
  return typeof value.data === "string" && typeof value.type === "string";
}

function decodeBlobs(value) {
  if (Array.isArray(value)) {
    return typeof value[0] === "object" ? value.map(decodeBlobs) : value;
  }
  if (value === null || typeof value !== "object") return value;
  if (isBlob(value)) return decodeBlob(value);
  return Object.fromEntries(Object.entries(value).map(([key, part]) =>
    [key, key === "series" ? part : decodeBlobs(part)]));
}

class Column {
  constructor({ name, unit, series }) {
    this.name = name;
    this.unit = unit;
    this.n = series.n;
    this.values = null;
    this.series = series;
  }

  /** The values, decoded once. */
  load() {
    this.loading ??= decodeSeries(this.series).then((values) => {
      this.values = values;
      this.series = null;
      return values;
    });
    return this.loading;
  }
}

const isForce = (name) => /_F[1-6]$/.test(name);

async function readRun(run) {
  run.columns = (run.columns ?? []).map((column) => new Column(column));
  run.column = (name) => run.columns.find((column) => column.name === name);
  await Promise.all(run.columns.filter(({ name }) => !isForce(name)).map((c) => c.load()));
  return run;
}

function parsed(text) {
  try {
    return JSON.parse(text);
  } catch (error) {
    throw new Error(`data: the file is damaged, write it again: ${error.message}`);
  }
}

/** The page's object from the text of its data. */
export async function readPage(text) {
  if (/^\s*(\/\*|$)/.test(text)) {
    throw new Error("this is the template of the page, without data: `cutwater report` fills it");
  }
  const page = decodeBlobs(parsed(text));
  if (page.format !== 1) throw new Error(`data: format ${page.format}; this page reads format 1`);
  page.raos ??= [];
  page.gates ??= [];
  page.runs = await Promise.all((page.runs ?? []).map(readRun));
  return page;
}
