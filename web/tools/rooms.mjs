/**
 * Rooms in which browsers that want to play together leave each other an invitation and its answer
 * (web/src/panels/match/meet.ts). `rooms/NAME/offer` and `rooms/NAME/answer` are put as text, and
 * taken by GET: 204 where nothing lies there. An invitation that somebody has taken and not answered
 * for a while may be taken by another. All is in memory, and nothing is kept for long.
 */
import { ISOLATION } from "./headers.mjs";

const PATH = /^rooms\/([a-z0-9-]{1,40})\/(offer|answer)$/;
/** Bytes of a text at most, rooms at most, and milliseconds after which a room that nobody asks about is
 * closed: who has opened it asks every second. Chosen. */
const LARGEST = 4000;
const MOST_ROOMS = 1000;
const KEPT = 6000;
/** Milliseconds after which an invitation that was taken and not answered lies there again. An answer
 * takes a second or two, and who comes looks for an invitation for ten (meet.ts). Chosen. */
const UNANSWERED = 8000;
const METHODS = ["GET", "PUT", "DELETE"];

/** Returns a function that answers a request for a path, or returns false where it is none of rooms. */
export function createRooms(now = Date.now) {
  const rooms = new Map();
  const takeAnswer = (room) => {
    const { answer } = room;
    Object.assign(room, { answer: undefined, asked: now() });
    return answer;
  };
  const takeOffer = (room) => {
    if (now() - room.taken <= UNANSWERED) return undefined;
    room.taken = now();
    return room.offer;
  };
  return (path, request, response) => {
    const reply = (status, text = "", headers = {}) => {
      const type = { "Content-Type": "text/plain; charset=utf-8", "Cache-Control": "no-store" };
      response.writeHead(status, { ...ISOLATION, ...type, ...headers });
      response.end(text);
    };
    if (path === "rooms.json") {
      reply(200, '{"rooms":true}\n', { "Content-Type": "application/json" });
      return true;
    }
    const [, name, what] = PATH.exec(path) ?? [];
    if (!name) return false;
    for (const [other, { asked }] of rooms) if (now() - asked > KEPT) rooms.delete(other);
    const room = rooms.get(name);
    if (!METHODS.includes(request.method)) reply(405, "", { Allow: METHODS.join(", ") });
    else if (request.method === "DELETE") {
      rooms.delete(name);
      reply(204);
    } else if (request.method === "GET") {
      const text = room && (what === "answer" ? takeAnswer(room) : takeOffer(room));
      if (text) reply(200, text);
      else reply(204);
    } else if (what === "answer" ? !room : !room && rooms.size >= MOST_ROOMS) reply(503);
    else
      read(request).then(
        (text) => {
          if (what === "offer") rooms.set(name, { offer: text, asked: now(), taken: -Infinity });
          else Object.assign(room, { answer: text, offer: undefined });
          reply(204);
        },
        () => reply(413, "", { Connection: "close" }),
      );
    return true;
  };
}

/** The text that a request brings; throws where it is too long. */
async function read(request) {
  let text = "";
  for await (const part of request) {
    text += part;
    if (text.length > LARGEST) throw new RangeError("too long");
  }
  return text;
}
