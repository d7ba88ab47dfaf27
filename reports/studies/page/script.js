for (const table of document.querySelectorAll('table.sortable')) {
  const body = table.tBodies[0];
  table.tHead.addEventListener('click', event => {
    const head = event.target.closest('th');
    if (!head) return;
    const rising = head.getAttribute('aria-sort') !== 'ascending';
    for (const other of table.querySelectorAll('th')) other.setAttribute('aria-sort', 'none');
    head.setAttribute('aria-sort', rising ? 'ascending' : 'descending');
    const key = row => row.cells[head.cellIndex].textContent;
    const number = text => text === 'exact' ? 0 : Number(text);
    const compare = (a, b) => {
      if (key(a) === '' || key(b) === '') return (key(a) === '') - (key(b) === '');  // empty cells come last
      const x = number(key(a)), y = number(key(b));
      if (isNaN(x) && isNaN(y)) return (rising ? 1 : -1) * key(a).localeCompare(key(b));
      return isNaN(x) ? 1 : isNaN(y) ? -1 : rising ? x - y : y - x;
    };
    const rows = [...body.rows].sort(compare);
    body.append(...rows);
  });
}
const search = document.querySelector('input[type=search]');
if (search) search.addEventListener('input', () => {
  const words = search.value.toLowerCase().split(/\s+/).filter(Boolean);
  let shown = 0;
  for (const row of document.querySelector('table.sortable').tBodies[0].rows) {
    row.hidden = !words.every(word => row.textContent.toLowerCase().includes(word));
    if (!row.hidden) ++shown;
  }
  document.querySelector('#shown').textContent = shown + ' shown';
});
const language = document.querySelector('select');
if (language) {
  const show = () => {
    for (const code of document.querySelectorAll('.code')) code.hidden = code.dataset.language !== language.value;
  };
  language.addEventListener('change', show);
  show();
}
for (const code of document.querySelectorAll('.code')) {
  code.querySelector('button').addEventListener('click', async event => {
    try {
      await navigator.clipboard.writeText(code.querySelector('pre').textContent);
      event.target.textContent = 'copied';
    } catch {  // without https a browser may refuse
      getSelection().selectAllChildren(code.querySelector('pre'));
      event.target.textContent = 'selected';
    }
  });
}
