// Bytes that were packed by LZMA (docs/pack_module.js), a third fewer than gzip's, which browsers unpack by themselves. The format
// is Igor Pavlov's, without its header, with three bits of context from the byte before: https://www.7-zip.org/sdk.html
'use strict';

(function (home) {
    const LITERAL_BITS = 3; // of the byte before, that say how the next is coded
    const STATES = 12; // of what came last: bytes, matches, repetitions; from 7 on no byte
    const AT_ONCE = 1 << 17; // bytes between two looks at what the page wants
    const EVEN = 1024; // a probability of one half

    // Of a whole word of bits, of which the highest come first, or last
    const tree = (bits) => new Uint16Array(1 << bits).fill(EVEN);

    // How long a match is: of three kinds
    class Lengths {
        constructor() { Object.assign(this, { choice: tree(1), low: tree(3), middle: tree(3), high: tree(8) }); }

        read(coder) {
            if (!coder.bit(this.choice, 0)) return 2 + coder.word(this.low, 3);
            if (!coder.bit(this.choice, 1)) return 10 + coder.word(this.middle, 3);
            return 18 + coder.word(this.high, 8);
        }
    }

    // A range that every bit narrows, the more the less it was expected
    class Coder {
        constructor(packed) {
            this.packed = packed;
            this.at = 5;
            this.range = 0xffffffff;
            this.code = new DataView(packed.buffer, packed.byteOffset).getUint32(1);
        }

        widen() {
            this.range = (this.range << 8) >>> 0;
            this.code = ((this.code << 8) | this.packed[this.at++]) >>> 0;
        }

        bit(chances, k) {
            const chance = chances[k];
            const bound = (this.range >>> 11) * chance;
            let bit = 0;
            if (this.code < bound) {
                this.range = bound;
                chances[k] = chance + ((2048 - chance) >> 5);
            } else {
                this.range -= bound;
                this.code -= bound;
                chances[k] = chance - (chance >> 5);
                bit = 1;
            }
            if (this.range < 0x1000000) this.widen();
            return bit;
        }

        word(chances, bits) {
            let at = 1;
            for (let k = 0; k < bits; ++k) at = at * 2 + this.bit(chances, at);
            return at - (1 << bits);
        }

        reversed(chances, bits, from = 0) {
            let at = 1;
            let word = 0;
            for (let k = 0; k < bits; ++k) {
                const bit = this.bit(chances, from + at);
                at = at * 2 + bit;
                word |= bit << k;
            }
            return word;
        }

        // Bits of which nothing is expected
        plain(bits) {
            let word = 0;
            for (let k = 0; k < bits; ++k) {
                this.range >>>= 1;
                const bit = this.code >= this.range ? 1 : 0;
                if (bit) this.code -= this.range;
                if (this.range < 0x1000000) this.widen();
                word = word * 2 + bit;
            }
            return word;
        }
    }

    function literal(coder, chances, from, match) {
        let at = 1;
        // Where a match has just ended, the byte that would have gone on with it is a hint, as long as it is right
        for (let hint = match; hint >= 0 && at < 256;) {
            const expected = (hint >> 7) & 1;
            hint = (hint << 1) & 0xff;
            const bit = coder.bit(chances, from + ((1 + expected) << 8) + at);
            at = at * 2 + bit;
            if (bit !== expected) break;
        }
        while (at < 256) at = at * 2 + coder.bit(chances, from + at);
        return at & 0xff;
    }

    function distance(coder, chances, length) {
        const slot = coder.word(chances.slots[Math.min(length - 2, 3)], 6);
        if (slot < 4) return slot;
        const bits = (slot >> 1) - 1;
        const start = (2 | (slot & 1)) * 2 ** bits;
        if (slot < 14) return start + coder.reversed(chances.near, bits, start - slot);
        return start + coder.plain(bits - 4) * 16 + coder.reversed(chances.aligned, 4);
    }

    // packed  a Uint8Array
    // size    of what was packed [bytes]
    async function unpack(packed, size) {
        const out = new Uint8Array(size);
        const coder = new Coder(packed);
        const chances = { slots: [tree(6), tree(6), tree(6), tree(6)], near: tree(7), aligned: tree(4) };
        const literals = new Uint16Array(0x300 << LITERAL_BITS).fill(EVEN);
        const [isMatch, isAgain, isOther, isThird, isFourth, isLong] = Array.from({ length: 6 }, () => new Uint16Array(STATES).fill(EVEN));
        const [fresh, again] = [new Lengths(), new Lengths()];
        let [last, second, third, fourth] = [0, 0, 0, 0]; // distances of the latest matches, less one
        let state = 0;
        for (let at = 0, pause = AT_ONCE; at < size;) {
            if (at > pause) {
                pause = at + AT_ONCE;
                await new Promise((done) => setTimeout(done));
            }
            if (!coder.bit(isMatch, state)) {
                const from = 0x300 * ((at ? out[at - 1] : 0) >> (8 - LITERAL_BITS));
                out[at] = literal(coder, literals, from, state < 7 ? -1 : out[at - last - 1]);
                ++at;
                state = state < 4 ? 0 : state < 10 ? state - 3 : state - 6;
                continue;
            }
            let length = 0;
            if (!coder.bit(isAgain, state)) {
                [second, third, fourth] = [last, second, third];
                length = fresh.read(coder);
                last = distance(coder, chances, length);
                state = state < 7 ? 7 : 10;
            } else {
                let isOne = false;
                if (!coder.bit(isOther, state)) {
                    isOne = !coder.bit(isLong, state);
                } else if (!coder.bit(isThird, state)) {
                    [last, second] = [second, last];
                } else if (!coder.bit(isFourth, state)) {
                    [last, second, third] = [third, last, second];
                } else {
                    [last, second, third, fourth] = [fourth, last, second, third];
                }
                length = isOne ? 1 : again.read(coder);
                state = isOne ? (state < 7 ? 9 : 11) : state < 7 ? 8 : 11;
            }
            if (last >= at) throw new Error('the packed engine is damaged');
            for (const end = Math.min(at + length, size); at < end; ++at) out[at] = out[at - last - 1];
        }
        return out;
    }

    home.flyingUnpack = unpack;
})(globalThis);
