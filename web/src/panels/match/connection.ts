/**
 * A connection of two browsers (WebRTC) with two channels: one whose packets may get lost or arrive
 * in another order, for inputs, and a reliable one for all data that must arrive.
 */
import {
  descriptionOf,
  type Invitation,
  packInvitation,
  readDescription,
} from "./invitation";

/**
 * Milliseconds for which a browser may search for its own addresses, since a STUN server may not
 * answer. Chosen.
 */
const GATHERING = 2500;
/**
 * If more bytes than this wait in the unreliable channel, packets are dropped, since each later
 * packet contains the inputs of earlier ones as well. Chosen.
 */
const FULL = 16_384;

/**
 * NOBODY: an address that belongs to no computer, since it is reserved for documentation (RFC
 * 5737). Firefox gives up a few seconds after it has tried all addresses that it knows of, but a
 * person takes longer to send the answer to an invitation. So while it waits, it is given this
 * address to try, with another port every TRY_ON milliseconds.
 */
const NOBODY = "198.51.100.1";
const TRY_ON = 4000;

/**
 * A worse network that is simulated: what is done to packets in addition to what the real network
 * does.
 */
export interface Line {
  /** Milliseconds that each packet is held back. */
  delay: number;
  /** The share of packets that are lost, 0 to 1. */
  loss: number;
}

export interface Calls {
  opened(): void;
  /** What the other has sent: bytes for the match, or a text for the page. */
  heard(data: ArrayBuffer | string): void;
  closed(): void;
}

export class Connection {
  readonly #peer: RTCPeerConnection;
  readonly #fast: RTCDataChannel;
  readonly #sure: RTCDataChannel;
  readonly #line: Line;
  readonly #calls: Calls;
  #tries: ReturnType<typeof setInterval> | undefined;
  /** How many times this browser was given the address NOBODY to try. */
  #tried = 0;
  #open = false;
  #closed = false;
  /**
   * Whether the connection ended because nothing arrived any more; false if one of the two browsers
   * closed it.
   */
  failed = false;

  /**
   * `server`: the address of a STUN server, by which browsers in different networks find each
   * other; "": none.
   */
  constructor(line: Line, server: string, calls: Calls) {
    this.#line = line;
    this.#calls = calls;
    const peer = new RTCPeerConnection({ iceServers: server ? [{ urls: server }] : [] });
    this.#peer = peer;
    const make = (label: string, id: number, options: RTCDataChannelInit) => {
      const channel = peer.createDataChannel(label, { negotiated: true, id, ...options });
      channel.binaryType = "arraybuffer";
      channel.addEventListener("open", () => this.#tellOpen());
      channel.addEventListener("close", () => this.close());
      channel.addEventListener("message", ({ data }) => calls.heard(data as ArrayBuffer | string));
      return channel;
    };
    this.#fast = make("inputs", 0, { ordered: false, maxRetransmits: 0 });
    this.#sure = make("match", 1, {});
    peer.addEventListener("connectionstatechange", () => {
      if (peer.connectionState !== "failed") return;
      this.failed = true;
      this.close();
    });
  }

  /** The text of an invitation to this connection, and its name, which the answer repeats. */
  async invite(): Promise<{ text: string; name: string }> {
    const own = await this.#describe("");
    return { text: await packInvitation(own), name: own.name };
  }

  /** The text of the answer to an invitation. */
  async answer(offer: Invitation): Promise<string> {
    await this.#peer.setRemoteDescription(descriptionOf(offer));
    this.#tries = setInterval(() => this.#tryOn(), TRY_ON);
    return packInvitation(await this.#describe(offer.name));
  }

  /** Connects with the browser that answered. */
  accept(answer: Invitation): Promise<void> {
    return this.#peer.setRemoteDescription(descriptionOf(answer));
  }

  /** Sends a packet, which may get lost. */
  send(bytes: Uint8Array<ArrayBuffer>): void {
    if (Math.random() < this.#line.loss) return;
    const act = () => {
      const { readyState, bufferedAmount } = this.#fast;
      if (readyState === "open" && bufferedAmount < FULL) this.#fast.send(bytes);
    };
    if (this.#line.delay > 0) setTimeout(act, this.#line.delay);
    else act();
  }

  /** Sends data that must arrive, on the reliable channel, in order. */
  sendSurely(data: Uint8Array<ArrayBuffer> | string): void {
    if (this.#sure.readyState === "open") this.#sure.send(data as string);
  }

  close(): void {
    if (this.#closed) return;
    this.#closed = true;
    clearInterval(this.#tries);
    this.#peer.close();
    this.#calls.closed();
  }

  #tellOpen(): void {
    if (this.#open || this.#fast.readyState !== "open" || this.#sure.readyState !== "open") return;
    this.#open = true;
    clearInterval(this.#tries);
    this.#calls.opened();
  }

  /**
   * Gives this browser one more address to try, so that it does not give up before the other one
   * has got the answer; see NOBODY.
   */
  #tryOn(): void {
    const number = ++this.#tried;
    const candidate = `candidate:${number} 1 udp 1 ${NOBODY} ${1024 + number} typ host`;
    this.#peer.addIceCandidate({ candidate, sdpMid: "0" }).catch(() => {});
  }

  /** The own description, once the own addresses are known. */
  async #describe(to: string): Promise<Invitation> {
    const peer = this.#peer;
    await peer.setLocalDescription();
    await new Promise<void>((done) => {
      const look = () => {
        if (peer.iceGatheringState === "complete") done();
      };
      peer.addEventListener("icegatheringstatechange", look);
      setTimeout(done, GATHERING);
      look();
    });
    return readDescription(peer.localDescription!, to);
  }
}
