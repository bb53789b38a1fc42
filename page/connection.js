// The line to the program: messages as JSON objects with a type, rows of pixels as bytes. When it breaks, it is taken up again.

import { withToken } from "./token.js";

const firstPause = 250;
const longestPause = 5000;

export class Connection {
  /** Told of `message` (an object), `rows` (an ArrayBuffer), `lost`, and `refused` where the program does not know the token: then it is not asked again. */
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
    const address = withToken("/live");
    address.protocol = "ws:";
    const socket = new WebSocket(address);
    let wasOpen = false;
    this.socket = socket;
    socket.binaryType = "arraybuffer";
    socket.addEventListener("open", () => {
      wasOpen = true;
      this.pause = firstPause;
    });
    socket.addEventListener("message", ({ data }) => {
      if (socket !== this.socket) return;
      if (typeof data === "string") this.listener.message(JSON.parse(data));
      else this.listener.rows(data);
    });
    socket.addEventListener("close", async () => {
      const isRefused = !wasOpen && (await refuses());
      if (socket !== this.socket) return;
      if (isRefused) return this.listener.refused();
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

/** Whether the program is there and does not know the token. A socket that fails does not say why. */
const refuses = () => fetch(withToken("/live")).then(({ status }) => status === 403, () => false);
