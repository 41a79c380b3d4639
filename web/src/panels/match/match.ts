/**
 * The panel Match: the visitor plays the running game with others, over connections from browser to
 * browser. To connect, a link with an invitation is sent to them, and they send an answer back. The
 * panel also shows delays and corrections, and can simulate a worse network.
 */
import type { App } from "../../page/app";
import type { Panel } from "../../page/dock";
import { make } from "../../page/dom";
import { notice, say } from "../../page/messages";
import { messageOf } from "../../shared/error";
import type { MatchNews } from "../../worker/match";
import { fillList } from "../inside/values";
import "../../style/values.css";
import "../../style/match.css";
import { unpackInvitation } from "./invitation";
import { Lobby } from "./lobby";
import { hasRooms, meet, ROOM, type RoomState } from "./meet";

/** The mark in a link after which the name of a room follows, in place of an invitation. */
const ROOM_MARK = "~";
/**
 * The name of the BroadcastChannel on which a tab that was opened by the link of an answer hands
 * that answer to the tab that waits for it.
 */
const CHANNEL = "thud-match";
const INVITED =
  "You are invited to a match: play, or watch it. Either tells those who play this device’s address in the network.";
/** Milliseconds for which a tab with an answer waits until another tab takes it. Chosen. */
const HEARD = 1500;
/** The correction that is shown is the largest one of this many of the last news. Chosen. */
const CORRECTIONS = 50;
/** Milliseconds between two news (worker/match.ts). */
const NEWS_EVERY = 200;

export function createPanel(app: App): Panel {
  return { element: new MatchPanel(app).element };
}

/**
 * Stores in the session storage which room this tab is in, and whether it only watches, so that it
 * can return after a reload. "": none.
 */
function remember(room: string, watches = false): void {
  try {
    sessionStorage.matchRoom = room;
    sessionStorage.matchWatches = watches;
  } catch {
    // It is not kept.
  }
}

function recall(): { room: string; watched: boolean } {
  try {
    const room = String(sessionStorage.matchRoom ?? "");
    return { room: ROOM.test(room) ? room : "", watched: sessionStorage.matchWatches === "true" };
  } catch {
    return { room: "", watched: false };
  }
}

/** Opens this panel, unless another panel is open, since the match was cut off. */
function openPanel(): void {
  const dock = document.querySelector<HTMLElement>("#dock")!;
  if (dock.hidden) document.querySelector<HTMLElement>("button[data-panel=match]")?.click();
}

class MatchPanel {
  readonly element = make("div", { class: "match values-panel" });
  readonly #app: App;
  readonly #lobby: Lobby;
  readonly #offer = make("div", { class: "section", id: "match-offer" });
  readonly #who = make("p", { class: "who", role: "status" });
  readonly #start = make("button", { class: "wide primary", id: "match-start" }, "Start the match");
  readonly #leave = make("button", { class: "wide", id: "match-leave" }, "Leave");
  readonly #figures = make("dl", { class: "values", id: "match-figures" });
  readonly #trouble = make("p", { class: "bad", role: "status" });
  readonly #others = make("div", { class: "section" }, this.#who, this.#start, this.#leave);
  readonly #network = make("div", { class: "section network" });
  readonly #channel = new BroadcastChannel(CHANNEL);
  readonly #rooms = hasRooms();
  /** Whether the search for other players in a room is under way. */
  #meets = false;
  /** Whether a match ran when the panel was shown last. */
  #played = false;
  /** Ends the search for others in a room. */
  #meeting = new AbortController();
  readonly #corrections: number[] = [];
  readonly #replayed: number[] = [];

  constructor(app: App) {
    this.#app = app;
    this.#lobby = new Lobby(app, {
      changed: () => this.#show(),
      news: (news) => this.#tell(news),
      told: (text) => notice(text),
      tookOver: (closed) => this.#carryOn(closed),
      cut: () => openPanel(),
    });
    this.#start.addEventListener("click", () => void this.#lobby.start());
    this.#leave.addEventListener("click", () => {
      this.#meeting.abort();
      remember("");
      if (this.#lobby.playing) void app.restart();
      else this.#lobby.leave();
      this.#beginOffer();
    });
    this.#network.append(
      make("h3", {}, "The network"),
      this.#figures,
      this.#trouble,
      this.#slider("delay", "Delay, ms", 400, 10, (value) => (this.#lobby.line.delay = value)),
      this.#slider("loss", "Loss, %", 50, 1, (value) => (this.#lobby.line.loss = value / 100)),
      make("p", { class: "quiet" }, "Both are added to what this browser sends; the others have sliders of their own."),
    );
    this.element.append(this.#offer, this.#others, this.#network);
    this.#channel.addEventListener("message", ({ data }) => void this.#hearTab(data));
    app.listen({
      run: () => {
        this.#show();
        if (this.#lobby.isWatching) notice(this.#state);
      },
    });
    void this.#begin();
  }

  /**
   * Does what the page's address asks for: accept an invitation, hand over an answer, or neither.
   */
  async #begin(): Promise<void> {
    const { invite } = this.#app.state;
    if (invite?.startsWith(ROOM_MARK)) {
      this.#offerToMeet(invite.slice(ROOM_MARK.length));
      this.#show();
      return;
    }
    const room = invite === null ? recall().room : "";
    if (room) {
      this.#offerToMeet(room, `You were in the room “${room}”. The others may still play there.`);
      this.#show();
      return;
    }
    const invitation = invite === null ? null : await unpackInvitation(invite);
    if (invite === null) this.#beginOffer();
    else if (!invitation) this.#beginOffer("The invitation in this link is damaged.");
    else if (invitation.type === "answer") this.#handOver(invite);
    else {
      this.#offer.replaceChildren(make("p", {}, INVITED), ...this.#ways(() => this.#join(invite)));
    }
    this.#show();
  }

  /** The two ways to take part in a match. */
  #ways(join: () => Promise<void>): HTMLButtonElement[] {
    const way = (id: string, label: string, watches: boolean) => {
      const button = make("button", { class: watches ? "wide" : "wide primary", id }, label);
      button.addEventListener("click", () => {
        this.#lobby.watches = watches;
        void this.#act(button, join);
      });
      return button;
    };
    return [way("match-join", "Play", false), way("match-watch", "Watch", true)];
  }

  /** This tab was opened by the link of a room; or it was in one before, and `about` says so. */
  #offerToMeet(name: string, about = ""): void {
    if (!ROOM.test(name)) return this.#beginOffer("The invitation in this link is damaged.");
    if (!about) {
      this.#offer.replaceChildren(make("p", {}, INVITED), ...this.#ways(() => this.#meet(name, "open")));
      return;
    }
    const back = make("button", { class: "wide primary", id: "match-join" }, "Come back");
    back.addEventListener("click", () => {
      this.#lobby.watches = recall().watched;
      void this.#act(back, () => this.#meet(name, "open"));
    });
    const other = make("button", { class: "wide", id: "match-other" }, "Something else");
    other.addEventListener("click", () => {
      remember("");
      this.#beginOffer();
    });
    this.#offer.replaceChildren(make("p", {}, about), back, other);
  }

  /** Enters a room of the page's server. */
  async #meet(name: string, state: RoomState): Promise<void> {
    this.#meeting.abort();
    this.#meeting = new AbortController();
    const line = make("p", { role: "status" }, `In the room “${name}”. Others come by this link, or by the room’s name.`);
    this.#offer.replaceChildren(
      line,
      await this.#link(ROOM_MARK + name, "The link as a QR code: scan it with the other devices"),
    );
    remember(name, this.#lobby.watches);
    this.#meets = true;
    try {
      await meet(name, this.#lobby, this.#meeting.signal, state);
    } catch (error) {
      this.#beginOffer(`The room cannot be used: ${messageOf(error)}`);
    } finally {
      this.#meets = false;
    }
  }

  /** Shows how others are invited. */
  #beginOffer(text = ""): void {
    const invite = make("button", { class: "wide primary", id: "match-invite" }, "Invite by a link");
    invite.addEventListener("click", () => void this.#act(invite, () => this.#invite()));
    const server = make("input", {
      type: "text",
      id: "match-server",
      placeholder: "stun:example.org",
      autocomplete: "off",
      spellcheck: "false",
    });
    server.addEventListener("change", () => (this.#lobby.server = server.value.trim()));
    const name = make("input", {
      type: "text",
      id: "match-room",
      placeholder: "any name",
      maxlength: 40,
      autocomplete: "off",
      autocapitalize: "none",
      spellcheck: "false",
      value: recall().room,
    });
    const enter = make("button", { class: "plain", id: "match-meet" }, "Meet there");
    enter.addEventListener("click", () => {
      const wanted = name.value.trim().toLowerCase();
      if (ROOM.test(wanted)) void this.#act(enter, () => this.#meet(wanted, "unknown"));
      else notice("A room’s name has letters from a to z, digits and hyphens.");
    });
    const room = make(
      "div",
      { hidden: true },
      make("label", { for: "match-room" }, "Or meet in a room of this page’s server"),
      make("div", { class: "row" }, name, enter),
    );
    void this.#rooms.then((has) => (room.hidden = !has));
    this.#offer.replaceChildren(
      make("p", text ? { class: "bad" } : {}, text || this.#about()),
      invite,
      room,
      make(
        "details",
        {},
        make("summary", {}, "Others in another network"),
        make("label", { for: "match-server" }, "A STUN server, by which your router lets them in"),
        server,
      ),
    );
  }

  #about(): string {
    const { playing, carries } = this.#lobby;
    const { room } = recall();
    if (carries && room) return `Others can still join. Whom you have lost may be in the room “${room}”.`;
    if (playing) return "Others can still join, and who was lost comes back by a new link.";
    const most = Math.min(4, this.#app.scene?.sizes?.most ?? 2);
    const who = most === 2 ? "Another player joins from another browser" : "Up to three others join from their own browsers";
    return `${who}, and others watch. What you play goes from device to device.`;
  }

  async #invite(): Promise<void> {
    const text = await this.#lobby.invite();
    const answer = make("textarea", {
      id: "match-answer",
      rows: 2,
      placeholder: "Paste the answer here",
      "aria-label": "The answer",
      autocomplete: "off",
      spellcheck: "false",
    });
    answer.addEventListener("input", () => void this.#take(answer.value));
    this.#offer.replaceChildren(
      make("h3", {}, "1. Send this link"),
      await this.#link(text, "The link as a QR code: scan it with the other device"),
      make("h3", {}, "2. Paste what comes back"),
      answer,
    );
    this.#offer.querySelector<HTMLElement>("#match-copy")?.focus();
  }

  async #join(invite: string): Promise<void> {
    const offer = (await unpackInvitation(invite))!;
    const text = await this.#lobby.answer(offer);
    this.#offer.replaceChildren(
      make("h3", {}, "Send this answer back"),
      await this.#link(text, "The answer as a QR code: scan it with the device that invited you"),
      make("p", { class: "quiet" }, "Keep this page open. The match begins when the other has the answer and starts."),
    );
  }

  /**
   * This browser is the host now: it invites in the room in which the host before did, so that
   * others find it there.
   */
  #carryOn(closed: boolean): void {
    const { room } = recall();
    // If the host has not closed its page but only lost its connections, it still invites in the
    // room, and a second host must not.
    if (room && closed) void this.#meet(room, "left");
    else this.#beginOffer();
  }

  /** Takes an answer that was pasted, or came from another tab. Resolves to whether it was one. */
  async #take(text: string): Promise<boolean> {
    if (!text.trim()) return false;
    const answer = await unpackInvitation(text);
    try {
      if (answer && (await this.#lobby.accept(answer))) {
        say("Connecting");
        return true;
      }
      notice(answer ? "This answers another invitation." : "This is no answer, or only a part of one.");
    } catch (error) {
      notice(`The answer cannot be used: ${messageOf(error)}`);
    }
    return false;
  }

  /** This tab was opened by the link of an answer: the tab that waits for it gets it. */
  #handOver(invite: string): void {
    const line = make("p", { role: "status" }, "Looking for the tab with the invitation…");
    this.#offer.replaceChildren(line);
    this.#channel.postMessage({ answer: invite });
    const timer = setTimeout(() => {
      line.textContent = "No tab of this browser waits for this answer.";
    }, HEARD);
    this.#channel.addEventListener("message", ({ data }) => {
      if ((data as { taken?: string } | null)?.taken !== invite) return;
      clearTimeout(timer);
      line.textContent = "The answer has arrived: go back to the tab with the invitation.";
    });
  }

  async #hearTab(data: unknown): Promise<void> {
    const answer = (data as { answer?: unknown } | null)?.answer;
    if (typeof answer !== "string" || !this.#offer.querySelector("#match-answer")) return;
    if (await this.#take(answer)) this.#channel.postMessage({ taken: answer });
  }

  /** A field with a link, its buttons, and its picture. */
  async #link(text: string, label: string): Promise<HTMLElement> {
    const url = new URL(location.pathname, location.href);
    url.search = new URLSearchParams({ scene: this.#app.state.scene }).toString();
    url.hash = `invite=${text}`;
    const field = make("input", { type: "text", readonly: true, id: "match-link", value: url.href, "aria-label": "Link" });
    field.addEventListener("focus", () => field.select());
    const copy = make("button", { class: "plain", id: "match-copy" }, "Copy");
    copy.addEventListener("click", () => {
      const copied = navigator.clipboard?.writeText(url.href) ?? Promise.reject(new Error());
      copied.then(
        () => notice("The link is in the clipboard."),
        () => {
          field.focus();
          notice("The clipboard is not allowed here: copy the link from the field.");
        },
      );
    });
    const row = make("div", { class: "row" }, field, copy);
    if (typeof navigator.share === "function") {
      const share = make("button", { class: "plain" }, "Share");
      share.addEventListener("click", () => void navigator.share({ url: url.href }).catch(() => {}));
      row.append(share);
    }
    const { drawCode } = await import("./qr");
    return make("div", { class: "link" }, row, drawCode(url.href, label) as unknown as HTMLElement);
  }

  #slider(name: string, label: string, most: number, step: number, set: (value: number) => void): HTMLElement {
    const input = make("input", { type: "range", id: `match-${name}`, min: 0, max: most, step, value: 0 });
    const output = make("output", { "aria-hidden": "true" }, "0");
    input.addEventListener("input", () => {
      set(input.valueAsNumber);
      output.textContent = input.value;
    });
    return make("label", { class: "slider" }, make("span", {}, label), input, output);
  }

  /** Runs `act` for a button, which is disabled until it has finished. */
  async #act(button: HTMLButtonElement, act: () => Promise<void>): Promise<void> {
    button.disabled = true;
    try {
      await act();
    } catch (error) {
      notice(`This browser cannot connect: ${messageOf(error)}`);
    }
    button.disabled = false;
  }

  /** How many others there are, in words. */
  get #count(): string {
    const { connected, watching } = this.#lobby;
    const number = (count: number) => (count === 1 ? "one other" : `${count} others`);
    const players = connected - watching;
    const who = watching === 1 ? "one who watches" : `${watching} who watch`;
    if (watching === 0) return number(players);
    return players === 0 ? who : `${number(players)} and ${who}`;
  }

  get #state(): string {
    const { connected, watching, playing, invited, isWatching, watches, carries } = this.#lobby;
    const count = this.#count;
    if (!playing && invited) return `Connected${watches ? " to watch" : ""}. Whoever invited you starts the match.`;
    if (!playing) return `Connected: ${count}.`;
    if (isWatching) return watches ? "You watch the match." : "All places are taken: you watch the match.";
    if (invited) return "The match runs.";
    const begin = carries ? "The player who invited you has left, and you carry the match on" : "The match runs";
    if (connected > watching) return `${begin}, with ${count}.`;
    if (carries) return `${begin}, alone until another player comes.`;
    return `The match waits for another player${connected > 0 ? `, with ${count}` : ""}.`;
  }

  #show(): void {
    const lobby = this.#lobby;
    const { connected, playing, invited } = lobby;
    this.#others.hidden = this.#network.hidden = connected === 0 && !playing;
    this.#offer.hidden = (playing && invited) || lobby.isFull || (invited && connected > 0);
    // When the match for which a room was opened ends, the room is left as well.
    const ended = this.#played && !playing;
    this.#played = playing;
    if (ended) {
      this.#meeting.abort();
      const { room } = recall();
      if (invited && room) this.#offerToMeet(room, `The connection has ended. The match may go on in the room “${room}”.`);
      else this.#beginOffer(invited ? "The connection has ended. Who invited you can send you a new link." : "");
    }
    this.#start.hidden = playing || invited || connected === lobby.watching;
    this.#leave.textContent = playing ? "Leave the match" : "Disconnect";
    const before = this.#who.textContent;
    this.#who.textContent = this.#state;
    const changed = this.#who.textContent !== before;
    if (!invited && !this.#meets && changed && (connected > 0 || playing)) this.#beginOffer();
    const main = document.querySelector("main")!;
    // On a phone the panel stands over the game's buttons.
    if (playing && !main.hasAttribute("data-match") && matchMedia("(width < 40em)").matches)
      document.querySelector<HTMLElement>("#dock .close")!.click();
    main.toggleAttribute("data-match", playing);
    this.#trouble.textContent = "";
    if (!playing) fillList(this.#figures, []);
  }

  #tell(news: MatchNews): void {
    const { roundTrip, ahead, difference, final } = news;
    const push = (list: number[], value: number) => {
      list.push(value);
      if (list.length > CORRECTIONS) list.shift();
    };
    push(this.#corrections, news.correction);
    push(this.#replayed, news.replayed);
    const seconds = (Math.max(1, this.#replayed.length - 1) * NEWS_EVERY) / 1000;
    const again = (this.#replayed.at(-1)! - this.#replayed[0]!) / seconds;
    fillList(this.#figures, [
      ["There and back", roundTrip === null ? "–" : `${Math.round(roundTrip)} ms`],
      ["Rollbacks", String(news.rollbacks)],
      ["Steps run again", `${again.toFixed(0)} a second`],
      ["Largest correction", `${Math.max(...this.#corrections).toFixed(2)} lengths`],
      ["Ahead of the others", `${ahead.toFixed(1).replace("-0.0", "0.0")} steps`],
      ["Equal states", String(news.equal)],
      ["Refused packets", String(news.refused)],
    ]);
    const { dataset } = this.#figures;
    dataset.step = String(final.step);
    dataset.hash = final.hash;
    const text = difference ?? "";
    if (this.#trouble.textContent !== text) this.#trouble.textContent = text;
  }
}
