/**
 * Meets other players in a room of the page's server (tools/rooms.mjs), which passes on invitations
 * and answers, so that nobody has to send a link. The first browser in a room invites those that
 * come later.
 */
import { unpackInvitation } from "./invitation";
import type { Lobby } from "./lobby";

/**
 * Milliseconds between two requests to the room, and the number of them after which waiting for an
 * invitation or for the connection ends. Chosen.
 */
const PAUSE = 1000;
const LOOKS = 10;

/** Names of rooms, as in the server. */
export const ROOM = /^[a-z0-9-]{1,40}$/;

/** Whether the page's server has rooms; a static host has a file that says no. */
export async function hasRooms(): Promise<boolean> {
  try {
    const { rooms } = (await (await fetch("rooms.json")).json()) as { rooms?: unknown };
    return rooms === true;
  } catch {
    return false;
  }
}

/**
 * What is known of a room. "unknown": nothing; "open": another browser is in it, and its invitation
 * is awaited; "left": the browser that invited there has left, so that this one invites.
 */
export type RoomState = "unknown" | "open" | "left";

/**
 * Enters a room, and leaves it when `signal` is aborted. Resolves when this browser has answered an
 * invitation. A browser that invites stays in the room while a match runs, so that others can join,
 * and players who lost their connection can return.
 */
export async function meet(name: string, lobby: Lobby, signal: AbortSignal, state: RoomState): Promise<void> {
  let offer = state === "left" ? null : await ask(name, "offer");
  for (let i = 0; state === "open" && i < LOOKS && !offer && !signal.aborted; i++) {
    await pause();
    offer = await ask(name, "offer");
  }
  if (offer) {
    const invitation = await unpackInvitation(offer);
    if (invitation?.type !== "offer") throw new Error("The room has a damaged invitation.");
    await ask(name, "answer", "PUT", await lobby.answer(invitation));
    return;
  }
  // The invitation is withdrawn when the page is closed, so that nobody answers it.
  const close = () => void ask(name, "offer", "DELETE").catch(() => {});
  window.addEventListener("pagehide", close);
  try {
    const goesOn = () => !signal.aborted && !lobby.isFull;
    while (!signal.aborted) {
      if (lobby.isFull) {
        await pause();
        continue;
      }
      await ask(name, "offer", "PUT", await lobby.invite());
      let answer: string | null = null;
      while (goesOn() && !answer) {
        await pause();
        answer = await ask(name, "answer");
      }
      const invitation = answer && (await unpackInvitation(answer));
      if (!invitation || !(await lobby.accept(invitation))) continue;
      for (let i = 0; i < LOOKS && goesOn() && lobby.isConnecting; i++) await pause();
    }
  } finally {
    window.removeEventListener("pagehide", close);
    await ask(name, "offer", "DELETE");
  }
}

function pause(): Promise<void> {
  return new Promise((done) => setTimeout(done, PAUSE));
}

async function ask(name: string, what: string, method = "GET", body?: string): Promise<string | null> {
  const response = await fetch(`rooms/${name}/${what}`, { method, body, keepalive: method === "DELETE" });
  if (!response.ok) throw new Error(`The server answers ${response.status}.`);
  return response.status === 204 ? null : response.text();
}
