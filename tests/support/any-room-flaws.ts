import { packGlb } from "../../tools/models/glb-builder.mjs";
import { edited, fixture, opened, type Served } from "./any-room.ts";

const GLB = fixture("plain.glb");
const SIGN = opened("plain.glb");
/** Where the positions of the sign begin in its binary chunk. */
const POSITIONS: number = SIGN.json.bufferViews[1].byteOffset;

const json = (change: Parameters<typeof edited>[1]) => edited("plain.glb", change);

/** The sign with another number in its header. */
function word(offset: number, value: number): Buffer {
  const glb = Buffer.from(GLB);
  glb.writeUInt32LE(value, offset);
  return glb;
}

/** The sign with another number among its positions. */
function coordinate(index: number, value: number): Buffer {
  const binary = Buffer.from(SIGN.binary);
  binary.writeFloatLE(value, POSITIONS + index * 4);
  return packGlb(SIGN.json, binary);
}

/** What is wrong with a file, the file, and how its sentence ends. */
export const FLAWS: Readonly<Record<string, { served: Served; says: RegExp }>> = {
  "a missing file": {
    served: { body: "", status: 404 },
    says: /could not be fetched: the server answers 404 Not Found\.$/,
  },
  "a web page": {
    served: { body: "<!doctype html><title>Home</title>", contentType: "text/html" },
    says: /is a web page, says its server \(text\/html\)\.$/,
  },
  "a web page that claims to be a model": {
    served: { body: "<!doctype html><title>Home</title>" },
    says: /is a web page, not a model\.$/,
  },
  "a picture": {
    served: { body: fixture("separate.png"), contentType: "image/png" },
    says: /is something else, says its server \(image\/png\)\.$/,
  },
  "a picture that claims to be a model": {
    served: { body: fixture("separate.png") },
    says: /is not a glTF model\.$/,
  },
  "an empty file": { served: { body: "" }, says: /is empty\.$/ },
  "a truncated file": {
    served: { body: GLB.subarray(0, 700) },
    says: /is cut short: 700 of 1572 bytes are there\.$/,
  },
  "a header without a body": {
    served: { body: GLB.subarray(0, 12) },
    says: /is cut short: 12 of at least 20 bytes are there\.$/,
  },
  "a file longer than it says": {
    served: { body: Buffer.concat([GLB, Buffer.alloc(8)]) },
    says: /says that it has 1572 bytes, but has 1580\.$/,
  },
  "a chunk longer than the file": {
    served: {
      body: word(12, 999_999),
    },
    says: /has a chunk of 999999 bytes that runs beyond its end\.$/,
  },
  "glTF 1": {
    served: {
      body: word(4, 1),
    },
    says: /is glTF 1, and only glTF 2 can be read\.$/,
  },
  "JSON that does not end": {
    served: { body: packGlb('{"asset": {"version": "2.0"', Buffer.alloc(4)) },
    says: /holds JSON that cannot be parsed\.$/,
  },
  "JSON of something else": {
    served: { body: '{"name": "my package"}', contentType: "application/json" },
    says: /is no glTF: it does not say of which version it is\.$/,
  },
  "a list where an object belongs": {
    served: { body: json((json) => (json.nodes = [[]])) },
    says: /is broken: nodes\[0\] is not an object\.$/,
  },
  "a scene without nodes": {
    served: { body: json((json) => (json.scenes = [{}])) },
    says: /holds no geometry\.$/,
  },
  "nodes without triangles": {
    served: { body: json((json) => (json.nodes = [{}, { name: "empty" }])) },
    says: /holds no geometry\.$/,
  },
  "a node that is its own child": {
    served: { body: json((json) => (json.nodes[0].children = [0])) },
    says: /is broken: nodes\[0\] is its own ancestor\.$/,
  },
  "nodes in a ring": {
    served: {
      body: json((json) => {
        json.nodes[0].children = [1];
        json.nodes[1].children = [0];
      }),
    },
    says: /is broken: nodes\[0\] is its own ancestor\.$/,
  },
  "a child of two nodes": {
    served: {
      body: json((json) => {
        json.nodes.push({ children: [1] }, { children: [1] });
      }),
    },
    says: /is broken: nodes\[1\] has two parents\.$/,
  },
  "ten thousand nodes inside each other": {
    served: {
      body: json((json) => {
        json.nodes = Array.from({ length: 10_000 }, (_, i) => ({
          children: i < 9_999 ? [i + 1] : [],
        }));
      }),
    },
    says: /is too deep: more than 500 nodes in nodes\.$/,
  },
  "a mesh that is not there": {
    served: { body: json((json) => (json.nodes[0].mesh = 7)) },
    says: /is broken: nodes\[0\]\.mesh names what is not there\.$/,
  },
  "an accessor beyond its buffer view": {
    served: { body: json((json) => (json.accessors[0].count = 5)) },
    says: /is broken: accessors\[0\]\.count runs beyond its buffer view\.$/,
  },
  "a buffer view beyond its buffer": {
    served: { body: json((json) => (json.bufferViews[1].byteLength = 1e6)) },
    says: /is broken: bufferViews\[1\]\.byteLength runs beyond its buffer\.$/,
  },
  "a buffer longer than its bytes": {
    served: { body: json((json) => (json.buffers[0].byteLength = 1e6)) },
    says: /is cut short: \d+ of 1000000 bytes of its buffer 0 are there\.$/,
  },
  "a triangle of vertices that are not there": {
    served: {
      body: json((json) => {
        json.accessors[4].bufferView = 2; // the normals' bytes
      }),
    },
    says: /is broken: a triangle has vertex \d+ of 4\.$/,
  },
  "such a triangle in its lower level of detail": {
    served: {
      body: json((json) => {
        json.accessors.push({ bufferView: 2, componentType: 5123, count: 6, type: "SCALAR" });
        json.meshes[0].primitives[0].extras = { reducedIndices: 5 };
      }),
    },
    says: /is broken: a triangle has vertex \d+ of 4\.$/,
  },
  "an attribute of the wrong type": {
    served: { body: json((json) => (json.meshes[0].primitives[0].attributes.POSITION = 3)) },
    says: /is broken: meshes\[0\]\.primitives\[0\]\.attributes\.POSITION is not of VEC3\.$/,
  },
  "a missing buffer": {
    served: { body: json((json) => (json.buffers[0].uri = "gone.bin")) },
    says: /needs a buffer that is not to be had: gone\.bin could not be fetched: .* 404 Not Found\.$/,
  },
  "no buffer at all": {
    served: {
      body: packGlb(SIGN.json, Buffer.alloc(0)),
    },
    says: /lacks its buffer 0\.$/,
  },
  "positions that are not numbers": {
    served: { body: coordinate(0, Number.NaN) },
    says: /has positions that are not numbers\.$/,
  },
  "positions without end": {
    served: { body: coordinate(3, Number.POSITIVE_INFINITY) },
    says: /has positions that are not numbers\.$/,
  },
  "a room of millimetres taken for metres": {
    served: { body: json((json) => (json.nodes[0].scale = [1e4, 1e4, 1e4])) },
    says: /is 20\.0 km large; glTF counts in metres\.$/,
  },
  "a room for nobody": {
    served: { body: json((json) => (json.nodes[0].scale = [1e-4, 1e-4, 1e-4])) },
    says: /is 0\.200 mm large; glTF counts in metres\.$/,
  },
  "a room out of reach": {
    served: { body: json((json) => (json.nodes[0].translation = [0, 3e6, 0])) },
    says: /stands 3\.00e\+3 km from its origin\.$/,
  },
  "a matrix of words": {
    served: { body: json((json) => (json.nodes[0].matrix = Array(16).fill("one"))) },
    says: /is broken: nodes\[0\]\.matrix holds what is not a number\.$/,
  },
  "six million triangles": {
    served: {
      body: json((json) => {
        const triangles = 1_500_000;
        json.accessors.push({ componentType: 5126, type: "VEC3", count: triangles * 3 });
        json.meshes[0].primitives = [{ attributes: { POSITION: json.accessors.length - 1 } }];
        json.nodes = Array.from({ length: 4 }, () => ({ mesh: 0 }));
        json.scenes[0].nodes = [...json.nodes.keys()];
      }),
    },
    says: /has too many triangles: 6 million, where 5 million are the limit\.$/,
  },
  "ten triangles, each amid two million vertices of its own": {
    served: {
      body: json((json) => {
        const [primitive] = json.meshes[0].primitives;
        json.meshes[0].primitives = Array.from({ length: 10 }, () => {
          json.accessors.push({ componentType: 5126, type: "VEC3", count: 2e6 });
          return { ...primitive, attributes: { POSITION: json.accessors.length - 1 } };
        });
      }),
    },
    says: /has too many vertices: 20 million, where 15 million are the limit\.$/,
  },
  "a billion positions of nothing": {
    served: {
      body: json((json) => {
        json.accessors.push({ componentType: 5126, type: "VEC3", count: 1e9 });
        json.meshes[0].primitives[0].attributes = { POSITION: json.accessors.length - 1 };
      }),
    },
    says: /has too many vertices: 1000 million, where 15 million are the limit\.$/,
  },
};
