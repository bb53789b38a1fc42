// The line to the program: messages as JSON objects with a type, rows of pixels as bytes. When it breaks, it is taken up again.

const firstPause = 250;
const longestPause = 5000;

export class Connection {
  /** Told of `message` (an object), `rows` (an ArrayBuffer) and `lost`. */
  constructor(listener) {
    this.listener = listener;
    this.pause = firstPause;
    this.open();
  }

  get isOpen() {
    return this.socket.readyState === WebSocket.OPEN;
  }

  /** Opens the line, or opens it anew. */
  open() {
    clearTimeout(this.timer);
    this.socket?.close();
    const socket = new WebSocket(`ws://${location.host}/live`);
    this.socket = socket;
    socket.binaryType = "arraybuffer";
    socket.addEventListener("open", () => {
      this.pause = firstPause;
    });
    socket.addEventListener("message", ({ data }) => {
      if (socket !== this.socket) return;
      if (typeof data === "string") this.listener.message(JSON.parse(data));
      else this.listener.rows(data);
    });
    socket.addEventListener("close", () => {
      if (socket !== this.socket) return;
      this.timer = setTimeout(() => this.open(), this.pause);
      this.listener.lost();
      this.pause = Math.min(longestPause, 2 * this.pause);
    });
  }

  /** Whether it could be sent. */
  send(message) {
    if (!this.isOpen) return false;
    this.socket.send(JSON.stringify(message));
    return true;
  }
}
