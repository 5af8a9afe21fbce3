// When something is there: in which configurations, and in which of the two states that are compared.

/** @typedef {import("../data").Mark} Mark */

/** Sets of moments (a configuration, before or after), each known by a small number: equal numbers are equal sets. */
export class Presence {
  /** @param {number} configurations how many there are @param {boolean} compared whether two states are */
  constructor(configurations, compared) {
    this.count = BigInt(Math.max(1, configurations));
    this.compared = compared;
    /** @type {bigint[]} */
    this.sets = [];
    /** @type {Map<bigint, number>} */
    this.numbers = new Map();
    /** @type {Map<string, number>} */
    this.read = new Map();
    this.half = (1n << this.count) - 1n;
    this.whole = this.number(compared ? (this.half << this.count) | this.half : this.half);
  }

  /**
   * @param {bigint} set
   * @returns {number}
   */
  number(set) {
    let found = this.numbers.get(set);
    if (found === undefined) {
      found = this.sets.length;
      this.sets.push(set);
      this.numbers.set(set, found);
    }
    return found;
  }

  /**
   * Of what exists in these configurations (none named: in all) and has this mark.
   * @param {number[]} only
   * @param {Mark | undefined} mark
   * @returns {number}
   */
  of(only, mark) {
    if (!only.length && !mark) return this.whole;
    const key = `${only.join()} ${mark ?? ""}`;
    let found = this.read.get(key);
    if (found === undefined) {
      let half = only.length ? 0n : this.half;
      for (const each of only) if (each >= 0 && BigInt(each) < this.count) half |= 1n << BigInt(each);
      const before = mark === "added" ? 0n : half;
      const after = mark === "removed" ? 0n : half;
      found = this.number(this.compared ? (before << this.count) | after : half);
      this.read.set(key, found);
    }
    return found;
  }

  /**
   * The moments of one configuration; of all, where it is negative.
   * @param {number} configuration
   */
  at(configuration) {
    if (configuration < 0 || BigInt(configuration) >= this.count) return this.whole;
    return this.of([configuration], undefined);
  }

  /** @param {number} one @param {number} other @returns {number} */
  both(one, other) {
    if (one === other || other === this.whole) return one;
    return this.number(this.set(one) & this.set(other));
  }

  /** @param {number} one @param {number} other @returns {boolean} */
  meet(one, other) {
    return (one === other ? this.set(one) : this.set(one) & this.set(other)) !== 0n;
  }

  /** @param {number} one @param {number} other @returns {number} */
  either(one, other) {
    return one === other ? one : this.number(this.set(one) | this.set(other));
  }

  /** @param {number} number */
  set(number) {
    return this.sets[number] ?? 0n;
  }

  /**
   * Whether it is there in some configurations only, of those in `within`.
   * @param {number} number
   * @param {number} within
   */
  conditional(number, within) {
    const set = this.set(number);
    const all = this.set(within);
    const missing = all & ~set;
    if (!this.compared) return missing !== 0n;
    const [before, after] = [set >> this.count, set & this.half];
    return (before !== 0n && (missing >> this.count) !== 0n) || (after !== 0n && (missing & this.half) !== 0n);
  }

  /**
   * What became of it between the two states.
   * @param {number} number
   * @returns {Mark | ""}
   */
  mark(number) {
    if (!this.compared) return "";
    const set = this.set(number);
    if (set >> this.count === 0n) return "added";
    return (set & this.half) === 0n ? "removed" : "";
  }
}
