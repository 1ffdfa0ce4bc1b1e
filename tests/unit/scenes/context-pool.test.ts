import { expect, test } from "vitest";
import { type ContextClient, ContextPool } from "../../../src/scenes/context-pool.ts";

/** A client that requests again whenever its context had to go. */
class Client implements ContextClient {
  isShown: boolean;
  holds = false;
  evictions = 0;
  readonly pool: ContextPool;

  constructor(pool: ContextPool, isVisible = true) {
    this.pool = pool;
    this.isShown = isVisible;
    pool.request(this);
  }

  isVisible(): boolean {
    return this.isShown;
  }

  acquire(): void {
    this.holds = true;
  }

  release(): void {
    this.holds = false;
    this.evictions++;
    this.pool.request(this);
  }

  show(isVisible: boolean): void {
    this.isShown = isVisible;
    this.pool.review();
  }

  close(): void {
    this.holds = false;
    this.pool.free(this);
  }
}

const holding = (clients: readonly Client[]) => clients.map(({ holds }) => holds);
const open = (pool: ContextPool, count: number) =>
  Array.from({ length: count }, () => new Client(pool));

test("as many clients hold a context as the pool has, in the order of their requests", () => {
  const clients = open(new ContextPool(() => 14), 20);
  expect(holding(clients)).toEqual(clients.map((_, i) => i < 14));
});

test("a request says whether there was a context at once", () => {
  const pool = new ContextPool(() => 1);
  const client = { isVisible: () => true, acquire() {}, release() {} };
  expect(pool.request(client)).toBe(true);
  expect(pool.request({ ...client })).toBe(false);
});

test("a client that closes lets the next one in", () => {
  const clients = open(new ContextPool(() => 2), 4);
  clients[0]?.close();
  expect(holding(clients)).toEqual([false, true, true, false]);
  clients[3]?.close(); // which only waited
  clients[1]?.close();
  expect(holding(clients)).toEqual([false, false, true, false]);
});

test("a visible client never gives way to a waiting one", () => {
  const pool = new ContextPool(() => 2);
  const clients = open(pool, 5);
  for (const client of clients) client.show(true);
  expect(clients.map(({ evictions }) => evictions)).toEqual([0, 0, 0, 0, 0]);
});

test("an invisible client gives way to a visible one, and comes back once it is visible", () => {
  const pool = new ContextPool(() => 2);
  const clients = open(pool, 3);
  const [first, , third] = clients;
  first?.show(false);
  expect(holding(clients)).toEqual([false, true, true]);
  expect(first?.evictions).toBe(1);
  third?.show(false);
  expect(holding(clients), "none that waits is visible").toEqual([false, true, true]);
  first?.show(true);
  expect(holding(clients)).toEqual([true, true, false]);
});

test("however the page scrolls, visible clients hold contexts, and none is evicted in vain", () => {
  const pool = new ContextPool(() => 4);
  const clients = Array.from({ length: 40 }, () => new Client(pool, false));
  for (let top = 0; top < 37; top++) {
    for (const [i, client] of clients.entries()) client.show(i >= top && i < top + 4);
    expect(holding(clients.slice(top, top + 4))).toEqual([true, true, true, true]);
  }
  const evictions = clients.reduce((sum, client) => sum + client.evictions, 0);
  expect(evictions).toBe(36);
});

test("visible clients come before invisible ones", () => {
  const pool = new ContextPool(() => 1);
  const [first] = open(pool, 1);
  const far = new Client(pool, false);
  const near = new Client(pool, true);
  first?.close();
  expect(holding([far, near])).toEqual([false, true]);
});
