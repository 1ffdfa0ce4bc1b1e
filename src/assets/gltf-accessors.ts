import { Flaw } from "./asset-error.js";
import type { JsonEntry } from "./json-entry.js";

/** Bytes of each component type; the numbers are GL's. */
const COMPONENT_BYTES = { 5120: 1, 5121: 1, 5122: 2, 5123: 2, 5125: 4, 5126: 4 } as const;
const TYPE_SIZES = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT2: 4, MAT3: 9, MAT4: 16 } as const;

type ComponentType = keyof typeof COMPONENT_BYTES;
export type AccessorType = keyof typeof TYPE_SIZES;

export type BufferView = Readonly<ReturnType<typeof readViews>[number]>;
export type MeshoptCompression = Readonly<ReturnType<typeof readMeshopt>>;
export type Accessor = Readonly<ReturnType<typeof readAccessors>[number]>;
type Sparse = NonNullable<ReturnType<typeof readSparse>>;

/** Most bytes that meshopt decodes, and of all accessors that are used, as floats: a small file can ask for any number. */
export const MOST_BYTES = 512e6;

export function readViews(
  entries: readonly JsonEntry[],
  buffers: readonly { readonly byteLength: number }[],
) {
  let decoded = 0;
  return entries.map((entry) => {
    const meshopt =
      entry.extension("EXT_meshopt_compression") ?? entry.extension("KHR_meshopt_compression");
    const stretch = meshopt ?? entry;
    const buffer = stretch.index("buffer", buffers.length);
    if (buffer === undefined) throw stretch.wrong("buffer", "is missing");
    const byteOffset = stretch.whole("byteOffset") ?? 0;
    const byteLength = stretch.whole("byteLength") ?? 0;
    if (byteOffset + byteLength > (buffers[buffer]?.byteLength ?? 0)) {
      throw stretch.wrong("byteLength", "runs beyond its buffer");
    }
    const compression = meshopt && readMeshopt(meshopt, byteLength);
    const decodedLength = compression ? compression.count * compression.byteStride : 0;
    decoded += decodedLength;
    if (decoded > MOST_BYTES) throw stretch.wrong("count", "is too large");
    return {
      buffer,
      byteOffset,
      byteLength: compression ? decodedLength : byteLength,
      byteStride: entry.whole("byteStride"),
      /** EXT_meshopt_compression of the view; its lengths then mean the decoded bytes. */
      meshopt: compression,
    };
  });
}

function readMeshopt(entry: JsonEntry, byteLength: number) {
  const count = entry.whole("count") ?? 0;
  const byteStride = entry.whole("byteStride") ?? 0;
  const mode = entry.string("mode") ?? "";
  if (!["ATTRIBUTES", "TRIANGLES", "INDICES"].includes(mode)) {
    throw entry.wrong("mode", "is none that is known");
  }
  return { byteLength, count, byteStride, mode, filter: entry.string("filter") };
}

export function readAccessors(entries: readonly JsonEntry[], views: readonly BufferView[]) {
  return entries.map((entry) => {
    const componentType = oneOf(COMPONENT_BYTES, entry.whole("componentType"));
    if (componentType === undefined) throw entry.wrong("componentType", "is none that is known");
    const type = oneOf(TYPE_SIZES, entry.string("type"));
    if (type === undefined) throw entry.wrong("type", "is none that is known");
    const count = entry.whole("count") ?? 0;
    const accessor = {
      view: entry.index("bufferView", views.length),
      byteOffset: entry.whole("byteOffset") ?? 0,
      componentType: Number(componentType) as ComponentType,
      type,
      count,
      isNormalized: entry.boolean("normalized"),
      sparse: readSparse(entry, views),
    };
    checkReach(entry, accessor, views);
    return accessor;
  });
}

function oneOf<Key extends string | number>(
  table: Readonly<Record<Key, number>>,
  key: string | number | undefined,
): Key | undefined {
  return key !== undefined && Object.hasOwn(table, key) ? (key as Key) : undefined;
}

/** Of its elements as floats, as which they are read. */
export function floatBytes({ type, count }: Accessor): number {
  return 4 * TYPE_SIZES[type] * count;
}

function elementBytes({ componentType, type }: Accessor): number {
  return COMPONENT_BYTES[componentType] * TYPE_SIZES[type];
}

function checkReach(entry: JsonEntry, accessor: Accessor, views: readonly BufferView[]): void {
  if (accessor.view === undefined || accessor.count === 0) return;
  const { byteLength, byteStride } = views[accessor.view] as BufferView;
  const size = elementBytes(accessor);
  const stride = byteStride || size;
  if (stride < size) throw entry.wrong("bufferView", "has a stride smaller than an element");
  if (accessor.byteOffset + stride * (accessor.count - 1) + size > byteLength) {
    throw entry.wrong("count", "runs beyond its buffer view");
  }
}

function readSparse(entry: JsonEntry, views: readonly BufferView[]) {
  const sparse = entry.entry("sparse");
  if (!sparse) return undefined;
  const indices = sparse.entry("indices");
  const values = sparse.entry("values");
  const indexView = indices?.index("bufferView", views.length);
  const valueView = values?.index("bufferView", views.length);
  const bytes = COMPONENT_BYTES[indices?.whole("componentType") as ComponentType];
  if (indexView === undefined || valueView === undefined || bytes === undefined) {
    throw entry.wrong("sparse", "lacks its indices or values");
  }
  return {
    count: sparse.whole("count") ?? 0,
    indices: { view: indexView, byteOffset: indices?.whole("byteOffset") ?? 0, bytes },
    values: { view: valueView, byteOffset: values?.whole("byteOffset") ?? 0 },
  };
}

/** An accessor's elements, tightly packed, with its sparse substitution applied. */
export async function denseBytes(
  accessor: Accessor,
  views: readonly BufferView[],
  bytesOf: (view: number) => Promise<Uint8Array>,
): Promise<Uint8Array<ArrayBuffer>> {
  const size = elementBytes(accessor);
  const dense = new Uint8Array(accessor.count * size);
  if (accessor.view !== undefined) {
    const source = (await bytesOf(accessor.view)).subarray(accessor.byteOffset);
    const stride = views[accessor.view]?.byteStride || size;
    if (stride === size) dense.set(source.subarray(0, dense.byteLength));
    else {
      for (let i = 0; i < accessor.count; i++) {
        dense.set(source.subarray(i * stride, i * stride + size), i * size);
      }
    }
  }
  if (accessor.sparse) await makeSparseChanges(dense, accessor, accessor.sparse, bytesOf);
  return dense;
}

async function makeSparseChanges(
  dense: Uint8Array,
  accessor: Accessor,
  { count, indices, values }: Sparse,
  bytesOf: (view: number) => Promise<Uint8Array>,
): Promise<void> {
  const size = elementBytes(accessor);
  const places = (await bytesOf(indices.view)).subarray(indices.byteOffset);
  const changes = (await bytesOf(values.view)).subarray(values.byteOffset);
  if (count * indices.bytes > places.byteLength || count * size > changes.byteLength) {
    throw new Flaw("is broken: a sparse accessor runs beyond its buffer views");
  }
  for (let i = 0; i < count; i++) {
    let place = 0;
    for (let byte = indices.bytes - 1; byte >= 0; byte--) {
      place = place * 256 + (places[i * indices.bytes + byte] ?? 0);
    }
    if (place >= accessor.count) {
      throw new Flaw("is broken: a sparse accessor changes what is not there");
    }
    dense.set(changes.subarray(i * size, (i + 1) * size), place * size);
  }
}
