/**
 * Meeting in a room of the page's server (tools/rooms.mjs): invitations and answers go by themselves.
 * Who comes first invites those who come later.
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
 * What is known of a room: nothing; that somebody is there, whose invitation is waited for; or that who
 * has invited there has left, so that this browser invites.
 */
export type RoomState = "unknown" | "open" | "left";

/**
 * Goes into a room until `signal` ends that. Resolves when this browser has answered an invitation. Who
 * invites stays, also while a match runs, so that others can join it and who was lost can come back.
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
  // Nobody is to answer an invitation of a page that is closed.
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
