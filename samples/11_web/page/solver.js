// The page's side of worker.js: questions and answers as promises.

export class Solver {
    #worker = new Worker('worker.js', { type: 'module' });
    #waiting = new Map();
    #next = 1;

    constructor() {
        this.ready = new Promise((resolve, reject) => {
            this.#worker.onmessage = ({ data }) => {
                if (data.ready) resolve();
                else if (data.failed) reject(new Error(data.failed));
                else this.#answer(data);
            };
            this.#worker.onerror = event => reject(new Error(event.message));
        });
    }

    open({ positions, indices, pieces, pieceCount, nodes }) {
        this.#worker.postMessage({ open: { positions, indices, pieces, pieceCount, nodes } });
    }

    /** Asks for the parts of the whole asset, or for one part, with joints. Rejects with the library's error. */
    solve(question, progress = () => {}) {
        const id = this.#next++;
        return new Promise((resolve, reject) => {
            this.#waiting.set(id, { resolve, reject, progress });
            this.#worker.postMessage({ id, ...question });
        });
    }

    #answer({ id, error, progress, ...answer }) {
        const { resolve, reject, progress: tell } = this.#waiting.get(id);
        if (progress !== undefined) {
            tell(progress);
            return;
        }
        this.#waiting.delete(id);
        if (error) reject(Object.assign(new Error(error.message), { code: error.code }));
        else resolve(answer);
    }
}
