/* fetch.mjs - fetches a file in the page's folder; on failure it throws one sentence that names the file. */

/* Fetches a file by its URL relative to this module, not to the page: if the page's own URL has a newline and a <,
   browsers fetch nothing that is relative to it. */
export async function fetchFile(path) {
    const answer = await fetch(new URL(path, import.meta.url)).catch(e => {
        throw new Error(`${path}: cannot be fetched: ${e.message}`);
    });
    if (!answer.ok)
        throw new Error(`${path}: ${answer.status} ${answer.statusText}; must be there as make web writes it`);
    return answer;
}
