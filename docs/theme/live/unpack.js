// Unpacks LZMA, for the engine's module: a sixth smaller than what browsers unpack by themselves, and a page is half engine.
// After Igor Pavlov's specification of the format, which is in the public domain.
'use strict';

(function (home) {
    const HALF = 1024; // of 2048: a bit of which nothing is known
    const fresh = (count) => new Uint16Array(count).fill(HALF);

    // Reads bits whose likelihoods are learnt on the way
    class Bits {
        constructor(bytes, at) {
            Object.assign(this, { bytes, at: at + 1, range: 0xffffffff, code: 0 });
            for (let k = 0; k < 4; ++k) this.code = ((this.code << 8) | bytes[this.at++]) >>> 0;
        }

        refill() {
            if (this.range >= 0x1000000) return;
            this.range = (this.range << 8) >>> 0;
            this.code = ((this.code << 8) | this.bytes[this.at++]) >>> 0;
        }

        bit(odds, k) {
            const bound = (this.range >>> 11) * odds[k];
            const isOne = this.code >= bound;
            if (isOne) {
                this.code -= bound;
                this.range -= bound;
                odds[k] -= odds[k] >>> 5;
            } else {
                this.range = bound;
                odds[k] += (2048 - odds[k]) >>> 5;
            }
            this.refill();
            return isOne ? 1 : 0;
        }

        // Bits that are as likely as not, the highest first
        plain(count) {
            let value = 0;
            for (; count > 0; --count) {
                this.range >>>= 1;
                const isOne = this.code >= this.range;
                if (isOne) this.code -= this.range;
                value = 2 * value + (isOne ? 1 : 0);
                this.refill();
            }
            return value;
        }

        // A number by its bits: from the highest, or from the lowest
        tree(odds, count, from = 0) {
            let node = 1;
            for (let k = 0; k < count; ++k) node = 2 * node + this.bit(odds, from + node);
            return node - (1 << count);
        }

        backwards(odds, count, from = 0) {
            let node = 1;
            let value = 0;
            for (let k = 0; k < count; ++k) {
                const bit = this.bit(odds, from + node);
                node = 2 * node + bit;
                value |= bit << k;
            }
            return value;
        }
    }

    // The length of a match, less two
    class Length {
        constructor() { Object.assign(this, { choice: fresh(2), low: fresh(16 * 8), middle: fresh(16 * 8), high: fresh(256) }); }

        read(bits, place) {
            if (!bits.bit(this.choice, 0)) return bits.tree(this.low, 3, 8 * place);
            if (!bits.bit(this.choice, 1)) return 8 + bits.tree(this.middle, 3, 8 * place);
            return 16 + bits.tree(this.high, 8);
        }
    }

    // From the bytes of a file .lzma, whose head says how long its text is
    function unpack(bytes) {
        const head = new DataView(bytes.buffer, bytes.byteOffset, 13);
        const lc = bytes[0] % 9;
        const lp = Math.floor(bytes[0] / 9) % 5;
        const pb = Math.floor(bytes[0] / 45);
        const out = new Uint8Array(head.getUint32(5, true));
        const bits = new Bits(bytes, 13);
        const [letters, isMatch, isLong] = [fresh(0x300 << (lc + lp)), fresh(12 * 16), fresh(12 * 16)];
        const [isKnown, isOlder, isThird, isFourth] = [fresh(12), fresh(12), fresh(12), fresh(12)];
        const [slots, special, align] = [fresh(4 * 64), fresh(128), fresh(16)];
        const [lengths, repeats] = [new Length(), new Length()];
        let last = [0, 0, 0, 0]; // distances of the last matches, less one
        let state = 0;

        for (let at = 0; at < out.length;) {
            const place = at & ((1 << pb) - 1);
            if (!bits.bit(isMatch, 16 * state + place)) {
                // One letter, which after a match is likely to differ from what stood there
                const before = at ? out[at - 1] : 0;
                const from = 0x300 * (((at & ((1 << lp) - 1)) << lc) + (before >> (8 - lc)));
                let node = 1;
                if (state >= 7)
                    for (let there = out[at - last[0] - 1]; node < 0x100;) {
                        const wanted = (there >> 7) & 1;
                        there <<= 1;
                        const bit = bits.bit(letters, from + ((1 + wanted) << 8) + node);
                        node = 2 * node + bit;
                        if (bit !== wanted) break;
                    }
                while (node < 0x100) node = 2 * node + bits.bit(letters, from + node);
                out[at++] = node & 0xff;
                state = state < 4 ? 0 : state < 10 ? state - 3 : state - 6;
                continue;
            }

            let length = 0;
            if (bits.bit(isKnown, state)) {
                // As far back as a match before; as the last one, it may be a single letter
                let isOne = false;
                if (!bits.bit(isOlder, state)) isOne = !bits.bit(isLong, 16 * state + place);
                else last.unshift(...last.splice(!bits.bit(isThird, state) ? 1 : !bits.bit(isFourth, state) ? 2 : 3, 1));
                length = isOne ? 1 : 2 + repeats.read(bits, place);
                state = state >= 7 ? 11 : isOne ? 9 : 8;
            } else {
                // A new distance: how many bits it has, then the bits
                length = 2 + lengths.read(bits, place);
                state = state < 7 ? 7 : 10;
                const slot = bits.tree(slots, 6, 64 * Math.min(length - 2, 3));
                let distance = slot;
                if (slot >= 4) {
                    const count = (slot >> 1) - 1;
                    distance = (2 | (slot & 1)) * 2 ** count;
                    if (slot < 14) distance += bits.backwards(special, count, distance - slot);
                    else distance += 16 * bits.plain(count - 4) + bits.backwards(align, 4);
                }
                last = [distance, ...last.slice(0, 3)];
            }
            for (const end = Math.min(at + length, out.length); at < end; ++at) out[at] = out[at - last[0] - 1];
        }
        return out;
    }

    home.FlyingUnpack = unpack;
})(globalThis);
