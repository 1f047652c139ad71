// Finds places of the book. An entry of the index is [title, where, address, weight, words]; every word of the question must
// begin some word of the entry. What stands in the title counts most, then what weighs most.
'use strict';

(function (home) {
    const plain = (text) => text.toLowerCase().normalize('NFD').replace(/[\u0300-\u036f]/g, '');
    // A word that others write in another way, as this book writes it
    const SPELLED = [[/^center/, 'centre'], [/^color/, 'colour'], [/^disk/, 'disc'], [/^licens/, 'licenc'], [/^meter/, 'metre'], [/(?<=\p{L}{3})iz(e|es|ed|ing|ation)$/u, 'is$1']];
    const spell = (word) => SPELLED.reduce((own, [from, to]) => own.replace(from, to), word);
    const wordsOf = (text) => plain(text).split(/[^\p{L}\p{N}.]+/u).filter(Boolean).map(spell);
    // What stands in the book may be asked for in one word, too: sub-step
    const joined = (text) => (plain(text).match(/\p{L}+-\p{L}+/gu) || []).map((word) => spell(word.replace('-', '')));

    // Forms of one word: axes and axis, polygons and polygon
    function stem(word) {
        if (word.length < 4 || /\d/.test(word)) return word;
        return word.replace(/(ies|ied)$/, 'y').replace(/(es|is|s|ed|ing|ly)$/, '');
    }

    function counted(words) {
        const counts = new Map();
        for (const word of words) counts.set(word, (counts.get(word) || 0) + 1);
        return counts;
    }

    function prepare(index) {
        if (index.prepared) return index.prepared;
        index.prepared = index.map(([title, where, address, weight, words]) =>
            ({ title, where, address, weight, inTitle: [...wordsOf(title), ...joined(title)], text: counted([words, where].flatMap((text) => [...wordsOf(text), ...joined(text)])) }));
        return index.prepared;
    }

    function worth(entry, asked) {
        let sum = 0;
        for (const word of asked) {
            const short = stem(word);
            const match = (own) => (own === word ? 3 : own.startsWith(word) ? 2 : short.length > 2 && own.startsWith(short) ? 1.5 : 0);
            let best = 0;
            for (const own of entry.inTitle) best = Math.max(best, 8 * match(own));
            for (const [own, count] of entry.text) best = Math.max(best, match(own) * (1 + 0.3 * Math.min(count, 9)));
            if (!best) return 0;
            sum += best;
        }
        // A title that says nothing else is what was meant, the more so word for word
        const same = entry.inTitle.length === asked.length && asked.every((word, k) => entry.inTitle[k] === word);
        return (sum * entry.weight * (same ? 1.3 : 1)) / (1 + 0.04 * entry.inTitle.length);
    }

    home.FlyingSearch = {
        find(index, question, most) {
            const asked = wordsOf(question);
            if (!asked.length) return [];
            const found = [];
            for (const entry of prepare(index)) {
                // A name as the code has it
                const score = worth(entry, asked) * (entry.title === question.trim() && entry.weight < 0.5 ? 40 : 1);
                if (score) found.push({ ...entry, score });
            }
            // Each place once
            const seen = new Set();
            return found.sort((a, b) => b.score - a.score).filter(({ address }) => !seen.has(address) && seen.add(address)).slice(0, most);
        },
    };
})(typeof window === 'undefined' ? globalThis : window);
