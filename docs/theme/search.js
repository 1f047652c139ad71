// Finds places of the book. An entry of the index is [title, where, address, weight, words]; every word of the question must
// begin some word of the entry. What stands in the title counts most, then what weighs most.
'use strict';

(function (home) {
    const plain = (text) => text.toLowerCase().normalize('NFD').replace(/[\u0300-\u036f]/g, '');
    const wordsOf = (text) => plain(text).split(/[^\p{L}\p{N}.]+/u).filter(Boolean);

    // Forms of one word: axes and axis, polygons and polygon
    function stem(word) {
        if (word.length < 4 || /\d/.test(word)) return word;
        return word.replace(/(ies|ied)$/, 'y').replace(/(es|is|s|ed|ing|ly)$/, '');
    }

    function prepare(index) {
        if (index.prepared) return index.prepared;
        index.prepared = index.map(([title, where, address, weight, words]) =>
            ({ title, where, address, weight, inTitle: wordsOf(title), text: [...new Set([...wordsOf(words), ...wordsOf(where)])] }));
        return index.prepared;
    }

    function worth(entry, asked) {
        let sum = 0;
        for (const word of asked) {
            const short = stem(word);
            const match = (own) => (own === word ? 3 : own.startsWith(word) ? 2 : short.length > 2 && own.startsWith(short) ? 1.5 : 0);
            let best = 0;
            for (const own of entry.inTitle) best = Math.max(best, 8 * match(own));
            if (!best) for (const own of entry.text) best = Math.max(best, match(own));
            if (!best) return 0;
            sum += best;
        }
        // A title that says nothing else is what was meant
        return (sum * entry.weight) / (1 + 0.04 * entry.inTitle.length);
    }

    home.FlyingSearch = {
        find(index, question, most) {
            const asked = wordsOf(question);
            if (!asked.length) return [];
            const found = [];
            for (const entry of prepare(index)) {
                const score = worth(entry, asked);
                if (score) found.push({ ...entry, score });
            }
            return found.sort((a, b) => b.score - a.score).slice(0, most);
        },
    };
})(typeof window === 'undefined' ? globalThis : window);
