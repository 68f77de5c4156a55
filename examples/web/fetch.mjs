/* fetch.mjs - fetches what lies beside the page; what does not come is thrown as one sentence that names the file. */

/* The place is told from here, not from the page: of an address with a newline and a < browsers fetch nothing that is
   relative to it. */
export async function fetchFile(path) {
    const answer = await fetch(new URL(path, import.meta.url)).catch(e => {
        throw new Error(`${path}: cannot be fetched: ${e.message}`);
    });
    if (!answer.ok)
        throw new Error(`${path}: ${answer.status} ${answer.statusText}; must be there as make web writes it`);
    return answer;
}
