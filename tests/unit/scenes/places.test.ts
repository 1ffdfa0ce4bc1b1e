import { expect, test } from "vitest";
import { type Guest, Places } from "../../../src/scenes/places.ts";

/** A room on a page with as many places as it is given. */
class Room implements Guest {
  isSeen = true;
  isIn = false;
  evictions = 0;
  readonly places: Places;

  constructor(places: Places, isSeen = true) {
    this.places = places;
    this.isSeen = isSeen;
    places.ask(this);
  }

  enter(): void {
    this.isIn = true;
  }

  yield(): void {
    this.isIn = false;
    this.evictions++;
    this.places.ask(this);
  }

  look(isSeen: boolean): void {
    this.isSeen = isSeen;
    this.places.review();
  }

  close(): void {
    this.isIn = false;
    this.places.leave(this);
  }
}

const within = (rooms: readonly Room[]) => rooms.map(({ isIn }) => isIn);
const open = (places: Places, count: number) =>
  Array.from({ length: count }, () => new Room(places));

test("as many rooms enter as there are places, in the order in which they came", () => {
  const rooms = open(new Places(() => 14), 20);
  expect(within(rooms)).toEqual(rooms.map((_, i) => i < 14));
});

test("asking says whether there was a place at once", () => {
  const places = new Places(() => 1);
  const guest = { isSeen: true, enter() {}, yield() {} };
  expect(places.ask(guest)).toBe(true);
  expect(places.ask({ ...guest })).toBe(false);
});

test("a room that closes lets the next one in", () => {
  const rooms = open(new Places(() => 2), 4);
  rooms[0]?.close();
  expect(within(rooms)).toEqual([false, true, true, false]);
  rooms[3]?.close(); // which only waited
  rooms[1]?.close();
  expect(within(rooms)).toEqual([false, false, true, false]);
});

test("nobody who is seen gives way, whoever waits", () => {
  const places = new Places(() => 2);
  const rooms = open(places, 5);
  for (const room of rooms) room.look(true);
  expect(rooms.map(({ evictions }) => evictions)).toEqual([0, 0, 0, 0, 0]);
});

test("a room out of sight gives way to one in sight, and comes back once it is seen", () => {
  const places = new Places(() => 2);
  const rooms = open(places, 3);
  const [first, , third] = rooms;
  first?.look(false);
  expect(within(rooms)).toEqual([false, true, true]);
  expect(first?.evictions).toBe(1);
  third?.look(false);
  expect(within(rooms), "nobody who waits is seen").toEqual([false, true, true]);
  first?.look(true);
  expect(within(rooms)).toEqual([true, true, false]);
});

test("however a visitor scrolls, whoever is seen is in, and nobody moves in vain", () => {
  const places = new Places(() => 4);
  const rooms = Array.from({ length: 40 }, () => new Room(places, false));
  for (let top = 0; top < 37; top++) {
    for (const [i, room] of rooms.entries()) room.look(i >= top && i < top + 4);
    expect(within(rooms.slice(top, top + 4))).toEqual([true, true, true, true]);
  }
  const evictions = rooms.reduce((sum, room) => sum + room.evictions, 0);
  expect(evictions).toBe(36);
});

test("those who are seen enter before those who are not", () => {
  const places = new Places(() => 1);
  const [first] = open(places, 1);
  const far = new Room(places, false);
  const near = new Room(places, true);
  first?.close();
  expect(within([far, near])).toEqual([false, true]);
});
