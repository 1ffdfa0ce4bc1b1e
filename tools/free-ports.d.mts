/** As many ports as are asked for, no two alike, on which nobody listens. */
export function freePorts(count: number): Promise<readonly number[]>;
