// Round the text of a page: dark or light, the contents on small screens, where the reader is, copying, searching.
'use strict';

(function () {
    const root = document.currentScript.dataset.root || '';
    const html = document.documentElement;

    // The same keys as the manual's, so that both are dark or both light
    const night = matchMedia('(prefers-color-scheme: dark)');
    const other = () => (night.matches ? 'prefers-light-mode-in-dark-mode' : 'prefers-dark-mode-in-light-mode');
    const kept = (key) => { try { return localStorage.getItem(key); } catch { return null; } };
    const isDark = () => (kept(other()) ? !night.matches : night.matches);
    const shade = () => html.classList.toggle('dark-mode', isDark());
    shade();
    night.addEventListener('change', shade);

    function turn() {
        try {
            if (kept(other())) localStorage.removeItem(other());
            else localStorage.setItem(other(), 'true');
            shade();
        } catch {
            html.classList.toggle('dark-mode');
        }
    }

    // ---- Contents ----

    function openContents(contents, button, open) {
        contents.classList.toggle('open', open);
        button.setAttribute('aria-expanded', String(open));
    }

    function follow() {
        const links = new Map([...document.querySelectorAll('nav.contents .here ul a')].map((link) => [link.hash.slice(1), link]));
        const headings = [...document.querySelectorAll('article h2[id], article h3[id]')].filter((heading) => links.has(heading.id));
        const contents = document.getElementById('contents');
        let last = null;
        const look = () => {
            const past = headings.filter((heading) => heading.getBoundingClientRect().top < 120);
            const link = past.length ? links.get(past[past.length - 1].id) : null;
            if (link === last) return;
            if (last) last.classList.remove('seen');
            if (link) {
                link.classList.add('seen');
                const box = link.getBoundingClientRect();
                if (box.height && (box.top < 80 || box.bottom > innerHeight - 20)) contents.scrollTop += box.top - innerHeight / 2;
            }
            last = link;
        };
        let waits = false;
        addEventListener('scroll', () => {
            if (waits) return;
            waits = true;
            requestAnimationFrame(() => { waits = false; look(); });
        }, { passive: true });
        const here = contents.querySelector('.here');
        if (here) contents.scrollTop = Math.max(0, here.offsetTop - 160);
        look();
    }

    // What is wider than its place is moved by the keyboard, too
    function reachWideOnes() {
        for (const element of document.querySelectorAll('main pre, main table, figure.map, .formula .sheet, div.fragment, .katex-display, ol.equations .entry')) {
            const isWide = element.scrollWidth > element.clientWidth + 1;
            if (isWide) element.tabIndex = 0;
            else element.removeAttribute('tabindex');
        }
    }

    // ---- Listings ----

    function addCopying() {
        if (!navigator.clipboard) return;
        for (const figure of document.querySelectorAll('figure.listing')) {
            const button = document.createElement('button');
            button.type = 'button';
            button.className = 'copy';
            button.textContent = 'Copy';
            button.onclick = async () => {
                const lines = [...figure.querySelectorAll('.fragment .line')].map((line) => line.textContent);
                await navigator.clipboard.writeText(lines.join('\n') + '\n');
                button.textContent = 'Copied';
                setTimeout(() => { button.textContent = 'Copy'; }, 1500);
            };
            figure.append(button);
        }
    }

    // ---- Search ----

    let dialog = null;

    function loadScript(name) {
        return new Promise((done, failed) => {
            const script = document.createElement('script');
            script.src = root + name;
            script.onload = done;
            script.onerror = failed;
            document.head.append(script);
        });
    }

    function show(list, query) {
        list.replaceChildren();
        const found = query.trim() ? FlyingSearch.find(window.flyingIndex, query, 30) : [];
        for (const { title, where, address } of found) {
            const item = document.createElement('li');
            const link = document.createElement('a');
            const name = document.createElement('b');
            const place = document.createElement('span');
            link.href = root + address;
            name.textContent = title;
            place.textContent = where;
            link.append(name, place);
            link.onclick = () => dialog.close();
            item.append(link);
            list.append(item);
        }
        if (found.length) list.firstChild.className = 'first';
        else if (query.trim()) list.append(Object.assign(document.createElement('p'), { textContent: 'Nothing found.' }));
    }

    async function search() {
        if (!dialog) {
            dialog = document.createElement('dialog');
            dialog.className = 'search';
            dialog.setAttribute('aria-label', 'Search');
            dialog.innerHTML = '<input type="search" aria-label="Search the book" placeholder="Search: restitution, parallel axes, (4.7), Polygon \u2026"><ol></ol>';
            document.body.append(dialog);
            const input = dialog.querySelector('input');
            const list = dialog.querySelector('ol');
            input.oninput = () => { if (window.flyingIndex) show(list, input.value); };
            dialog.addEventListener('keydown', (event) => {
                const links = [...list.querySelectorAll('a')];
                const at = links.indexOf(document.activeElement);
                if (event.key === 'Enter' && document.activeElement === input && links.length) links[0].click();
                else if (event.key === 'ArrowDown' && links.length) links[Math.min(at + 1, links.length - 1)].focus();
                else if (event.key === 'ArrowUp') (at > 0 ? links[at - 1] : input).focus();
                else return;
                event.preventDefault();
            });
            dialog.onclick = (event) => { if (event.target === dialog) dialog.close(); };
            dialog.showModal();
            await Promise.all([loadScript('theme/search.js'), loadScript('theme/search-index.js')]);
            show(list, input.value);
        } else {
            dialog.showModal();
        }
        dialog.querySelector('input').select();
    }

    addEventListener('DOMContentLoaded', () => {
        const contents = document.getElementById('contents');
        const menu = document.querySelector('.bar .menu');
        menu.onclick = () => openContents(contents, menu, !contents.classList.contains('open'));
        contents.addEventListener('click', (event) => { if (event.target.closest('a')) openContents(contents, menu, false); });
        document.querySelector('.bar .shade').onclick = turn;
        document.querySelector('.bar .find').onclick = search;
        addEventListener('keydown', (event) => {
            if (event.key === 'Escape') openContents(contents, menu, false);
            if (event.key !== '/' || event.ctrlKey || event.metaKey || /^(input|textarea|select)$/i.test(event.target.tagName)) return;
            event.preventDefault();
            search();
        });
        follow();
        addCopying();
        reachWideOnes();
        document.fonts.ready.then(reachWideOnes);
        addEventListener('resize', reachWideOnes, { passive: true });
    });
})();
