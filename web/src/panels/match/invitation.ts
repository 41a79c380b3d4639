/**
 * Invitations to a match and the answers to them, as short texts for a link. Each contains what one
 * browser must know to reach the other: the fields of an SDP description (RFC 8866) of a connection
 * that has only data channels. The receiver checks each field, since a link may come from a
 * stranger, and writes the description from them.
 */
import { pack, unpack } from "../../page/url";

/** The data by which another browser is reached. */
export interface Invitation {
  type: "offer" | "answer";
  /** The name and password by which the browsers find each other (ICE, RFC 8839). */
  name: string;
  password: string;
  /** SHA-256 of the certificate of the connection, 32 bytes in hexadecimal. */
  fingerprint: string;
  setup: "actpass" | "active" | "passive";
  candidates: Candidate[];
  /** In an answer: the `name` of the offer that it answers. */
  to: string;
}

/**
 * An address of the browser; `kind`: its own in its network ("host"), or the one at which a server
 * sees it.
 */
interface Candidate {
  address: string;
  port: number;
  kind: "host" | "srflx";
}

/** Addresses in an invitation at most. Chosen. */
const MOST_CANDIDATES = 12;

const NAME = /^[A-Za-z0-9+/]{4,256}$/;
const PASSWORD = /^[A-Za-z0-9+/]{22,256}$/;
const FINGERPRINT = /^[0-9a-f]{64}$/;
/** IPv4, IPv6, or a name by which browsers hide an address in a local network (mDNS). */
const ADDRESS = /^(\d{1,3}(\.\d{1,3}){3}|[0-9a-f]{0,4}(:[0-9a-f]{0,4}){2,7}|[0-9a-f-]{36}\.local)$/;

/** Reads a browser's own description. */
export function readDescription({ type, sdp }: RTCSessionDescription, to = ""): Invitation {
  const find = (pattern: RegExp) => pattern.exec(sdp)?.[1] ?? "";
  const candidates = [...sdp.matchAll(/^a=candidate:\S+ 1 udp \d+ (\S+) (\d+) typ (host|srflx)/gim)].map(
    ([, address, port, kind]) => ({
      address: address!.toLowerCase(),
      port: Number(port),
      kind: kind as Candidate["kind"],
    }),
  );
  return {
    type: type as Invitation["type"],
    name: find(/^a=ice-ufrag:(\S+)/m),
    password: find(/^a=ice-pwd:(\S+)/m),
    fingerprint: find(/^a=fingerprint:sha-256 (\S+)/im).replaceAll(":", "").toLowerCase(),
    setup: find(/^a=setup:(\S+)/m) as Invitation["setup"],
    candidates: candidates.slice(0, MOST_CANDIDATES),
    to,
  };
}

/** The description of an invitation for a browser. */
export function descriptionOf(invitation: Invitation): RTCSessionDescriptionInit {
  const { type, name, password, fingerprint, setup, candidates } = invitation;
  const lines = candidates.map(({ address, port, kind }, i) => {
    // RFC 8445, section 5.1.2.1: own addresses before those that a server sees, in their order.
    const priority = (kind === "host" ? 126 : 100) * 2 ** 24 + (65535 - i) * 2 ** 8 + 255;
    const base = kind === "host" ? "" : " raddr 0.0.0.0 rport 0";
    return `a=candidate:${i + 1} 1 udp ${priority} ${address} ${port} typ ${kind}${base}`;
  });
  const sdp = [
    ...["v=0", "o=- 1 1 IN IP4 127.0.0.1", "s=-", "t=0 0", "a=group:BUNDLE 0"],
    "m=application 9 UDP/DTLS/SCTP webrtc-datachannel",
    "c=IN IP4 0.0.0.0",
    ...lines,
    "a=end-of-candidates",
    `a=ice-ufrag:${name}`,
    `a=ice-pwd:${password}`,
    `a=fingerprint:sha-256 ${fingerprint.toUpperCase().match(/../g)!.join(":")}`,
    ...[`a=setup:${setup}`, "a=mid:0", "a=sctp-port:5000", "a=max-message-size:65536", ""],
  ];
  return { type, sdp: lines.length > 0 ? sdp.join("\r\n") : sdp.filter((one) => !one.startsWith("a=end")).join("\r\n") };
}

/** An invitation as a text for an address. */
export function packInvitation(invitation: Invitation): Promise<string> {
  const { type, name, password, fingerprint, setup, candidates, to } = invitation;
  const addresses = candidates.map(({ address, port, kind }) =>
    [address.replace(/\.local$/, "!"), port, kind === "host" ? 0 : 1].join(),
  );
  return pack([type[0], name, password, fingerprint, setup, to, ...addresses].join(" "));
}

/** The invitation in such a text, or in a link with it; null if it is none, or damaged. */
export async function unpackInvitation(text: string): Promise<Invitation | null> {
  const packed = /(?:^|invite=)([\w-]+)$/.exec(text.trim())?.[1];
  const fields = packed ? (await unpack(packed))?.split(" ") : null;
  if (!fields || fields.length < 6) return null;
  const [letter, name, password, fingerprint, setup, to, ...addresses] = fields as [
    ...[string, string, string, string, string, string],
    ...string[],
  ];
  const type = { o: "offer" as const, a: "answer" as const }[letter];
  const candidates = addresses.map((one): Candidate => {
    const [address = "", port, kind] = one.split(",");
    return {
      address: address.replace(/!$/, ".local"),
      port: Number(port),
      kind: kind === "1" ? "srflx" : "host",
    };
  });
  const isRight =
    type &&
    NAME.test(name) &&
    PASSWORD.test(password) &&
    FINGERPRINT.test(fingerprint) &&
    (type === "offer" ? ["actpass"] : ["active", "passive"]).includes(setup) &&
    (type === "offer" ? to === "" : NAME.test(to)) &&
    candidates.length <= MOST_CANDIDATES &&
    candidates.every(
      ({ address, port }) =>
        ADDRESS.test(address) && Number.isInteger(port) && port > 0 && port < 65536,
    );
  if (!isRight) return null;
  return { type, name, password, fingerprint, setup: setup as Invitation["setup"], candidates, to };
}
