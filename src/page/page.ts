import type { Camera, CandleFlameElement } from "../candle-flame-element.js";
import "../define.js";
import { nameKeys } from "../key-names.js";
import { FIELDS_OF_VIEW, parseIndices } from "../settings.js";
import { expectedLook, followDrawnLook, loadedLook } from "./drawn-look.js";
import { find } from "./find.js";
import { followAttributes } from "./follow-attributes.js";
import { fullResolution } from "./full-resolution.js";
import { followGamepads } from "./gamepad-entry.js";
import { holdPoster } from "./held-poster.js";
import { bindMicrophone } from "./microphone.js";
import { photograph } from "./photo.js";
import { addSettings } from "./settings-form.js";
import {
  readShareLink,
  SHARED,
  SHOWN,
  type Shared,
  type View,
  writeShareLink,
} from "./share-link.js";
import { reflectWalking } from "./walking.js";

const stage = find(document, ".stage", HTMLElement);
const room = find(document, "candle-flame", HTMLElement) as CandleFlameElement;
const enterButton = find(stage, ".enter", HTMLButtonElement);
const hint = find(stage, ".hint", HTMLElement);
const status = find(stage, ".status", HTMLElement);
const help = find(document, ".help", HTMLDialogElement);
const settings = find(document, ".settings-dialog", HTMLDialogElement);
const labButton = find(stage, ".lab-button", HTMLButtonElement);
const photoButton = find(stage, ".photo-button", HTMLButtonElement);
const shareButton = find(stage, ".share-button", HTMLButtonElement);
const fullScreenButton = find(stage, ".full-screen-button", HTMLButtonElement);
const notice = find(stage, ".notice", HTMLElement);
const link = find(stage, ".link", HTMLInputElement);

followDrawnLook(room);
reflectWalking(room);
void nameKeys(document.querySelectorAll<HTMLElement>(".with-keys kbd, .keyboard kbd"));
enterButton.addEventListener("click", () => room.enter());
followGamepads(room, enterButton);
// What is hidden while the visitor walks cannot take the focus.
room.addEventListener("keydown", ({ key }) => {
  if (key === "Tab") document.body.classList.remove("walking");
});
// Where there are no keys there is no Esc: a touch of this button takes the focus from the room, which ends the walk.
const leave = find(stage, ".leave", HTMLButtonElement);
room.addEventListener("leave", () =>
  setTimeout(() => {
    if ([document.body, leave].includes(document.activeElement as HTMLElement)) {
      enterButton.focus({ preventScroll: true });
    }
  }),
);
find(stage, ".help-button", HTMLButtonElement).addEventListener("click", () => show(help));

/** At its top, wherever it was left. */
function show(dialog: HTMLDialogElement): void {
  dialog.showModal();
  dialog.scrollTop = 0;
}

function showLoading(progress: number): void {
  // In quarters: a screen reader reads each change of this sentence aloud. What comes last cannot be counted.
  const sentence =
    progress < 1 ? `Loading the room: ${Math.floor(progress * 4) * 25} %` : "Preparing the light…";
  if (status.textContent !== sentence) status.textContent = sentence;
}
room.addEventListener("progress", ({ detail }) => showLoading(detail.totalProgress));
// The look that is asked for, and the one before.
let looks = [room.look, room.look] as const;
followAttributes(room, ["look"], () => {
  if (room.look !== looks[0]) looks = [room.look, looks[0]];
  // A look that is chosen and taken back meanwhile ends its loading without an event.
  if (room.flame) status.textContent = "";
});
room.addEventListener("load", () => welcome(true));
room.addEventListener("load", () => holdPoster(room), { once: true });
// After a context that was given up; without a room, one is still to load.
room.addEventListener("contextrestored", () => {
  if (room.flame) welcome(true);
});
room.addEventListener("error", ({ detail }) => {
  // The element itself says what is missing, unless the room before it goes on, drawn or still being prepared.
  const goesOn = room.flame || room.matches(":is(:state(loading), [state-loading])");
  if (detail.type !== "asset" || !goesOn) return welcome(false);
  if (room.flame) status.textContent = "";
  const look = room.flame ? loadedLook(room) : looks[1];
  tell(room.look === look ? detail.message : `${detail.message} The look stays ${look}.`);
  room.look = look; // so that controls and links have what is drawn, and the other can be chosen again
});

// The code of the scene comes before its files.
if (!room.flame) showLoading(0);

function welcome(isOpen: boolean): void {
  status.textContent = "";
  enterButton.disabled = !isOpen;
  enterButton.hidden = !isOpen;
  hint.hidden = !isOpen;
  photoButton.disabled = !isOpen;
  shareButton.disabled = !isOpen;
}

photoButton.addEventListener("click", async () => {
  if (photoButton.hasAttribute("aria-busy")) return;
  photoButton.setAttribute("aria-busy", "true");
  await fullResolution(room, () => tell("The photo waits until the image is sharp."));
  photoButton.removeAttribute("aria-busy");
  const blob = await photograph(room, stage).catch(() => null);
  if (!blob) return tell("There is no image at the moment.");
  const url = URL.createObjectURL(blob);
  const download = document.createElement("a");
  download.href = url;
  download.download = "candle-flame.png";
  download.click();
  setTimeout(() => URL.revokeObjectURL(url), 60_000); // some browsers read it only later
  const { width, height } = room.stats;
  tell(`Saved: ${width} x ${height} pixels.`);
});

/** Camera from which the standing candle was put down. */
let putDownFrom: Camera | null = null;
room.addEventListener("place", () => {
  putDownFrom = room.camera;
});
room.addEventListener("take", () => {
  putDownFrom = null;
});

/** Puts the candle down from a camera, or takes it up; afterwards the camera is another, or where it was. */
function setCandle(from: Camera | null, camera: Camera = room.camera): void {
  if (!from && room.held) return;
  if (!room.held) {
    if (putDownFrom) room.camera = putDownFrom; // within reach of it
    room.take();
  }
  if (from) {
    room.camera = from;
    room.place();
  }
  room.camera = camera;
}

/** View whose candle is put in its place once there is a room; null where nothing is left to do. */
let awaited: View | null = null;
room.addEventListener("load", () => {
  if (awaited) setCandle(awaited.candle);
  awaited = null;
});

/** Settings that the view does not name take their defaults. */
function applyView(view: View): void {
  awaited = null;
  for (const name of SHARED) {
    const text = view.settings[name];
    if (text === undefined) room.removeAttribute(name);
    else room.setAttribute(name, text);
  }
  applyFlames(view);
  // Another room may be on its way: this one's walls are not its.
  const look = room.flame ? expectedLook(room) : room.look;
  const camera = view.camera && { fieldOfView: FIELDS_OF_VIEW[look], ...view.camera };
  if (camera) room.camera = camera;
  // Before there is a room, a camera alone decides how it opens.
  if (room.flame || camera) setCandle(view.candle, camera ?? undefined);
  else awaited = view;
}

/** The visitor may have put out or lit candles without the attributes. */
function applyFlames({ settings }: View): void {
  const isUnlit = settings.unlit !== undefined;
  const lit = parseIndices(settings["lit-wicks"] ?? "") ?? [0];
  if (!room.flame) room.lit = !isUnlit && lit.includes(0);
  for (const [index, candle] of room.candles.entries()) {
    candle.lit = !isUnlit && lit.includes(index);
  }
}

/** Which candles burn, as the attributes that say so. */
function flameSettings({ candles }: CandleFlameElement): Partial<Record<Shared, string>> {
  const lit = [...candles.keys()].filter((index) => candles[index]?.lit);
  if (lit.length === 0) return { unlit: "" };
  return lit.join() === "0" ? {} : { "lit-wicks": lit.join(" ") };
}

/** View that the cabin opens with: its candle stands on the table, to be taken. */
const OPENING: Pick<View, "camera" | "candle"> = {
  camera: { position: [-0.6, 1.6, 0.85], yaw: -0.57, pitch: -0.4 },
  candle: { position: [-0.4, 1.6, 0.6], yaw: -0.94, pitch: -0.5 },
};
const takeUp = () => room.take();

/** Shows the view of the page's address; one that names no place opens as the cabin does. */
function followAddress(): void {
  const view = readShareLink(location.hash);
  const isOpening = !view.camera && !view.candle && !view.settings.look;
  applyView(isOpening ? { ...view, ...OPENING } : view);
  if (isOpening) room.addEventListener("enter", takeUp, { once: true });
  else room.removeEventListener("enter", takeUp); // a link says where its candle is
}
followAddress();
window.addEventListener("hashchange", () => {
  room.querySelector(".poster")?.remove(); // of the first view
  hideLink(); // to the view before
  followAddress();
});

/** How long a notice stays, milliseconds. */
const NOTICE = 6000;
let noticeTimer = 0;

function tell(sentence: string): void {
  notice.textContent = sentence;
  clearTimeout(noticeTimer);
  noticeTimer = window.setTimeout(() => {
    notice.textContent = "";
  }, NOTICE);
}

const COPY = "Copy this link.";

/** Where the clipboard is refused, until the visitor turns to something else. */
function showLink(): void {
  clearTimeout(noticeTimer);
  notice.textContent = COPY;
  link.value = location.href;
  link.hidden = false;
  link.focus();
  link.select();
}

function hideLink(): void {
  link.hidden = true;
  if (notice.textContent === COPY) notice.textContent = "";
}

link.addEventListener("blur", () => {
  // It may be pasted in another window, and copied once more.
  if (document.activeElement !== link) hideLink();
});
link.addEventListener("keydown", ({ key }) => {
  if (key === "Escape") shareButton.focus();
});
room.addEventListener("enter", hideLink);

shareButton.addEventListener("click", async () => {
  const settings: Partial<Record<Shared, string>> = {};
  for (const name of SHARED) {
    const text = room.getAttribute(name);
    if (text !== null && name !== "unlit" && name !== "lit-wicks") settings[name] = text;
  }
  Object.assign(settings, room.flame ? flameSettings(room) : room.lit ? {} : { unlit: "" });
  // Nobody put down the original's candle.
  const candle = room.look === "original" ? null : putDownFrom;
  history.replaceState(null, "", writeShareLink({ camera: room.camera, candle, settings }));
  hideLink();
  try {
    await navigator.clipboard.writeText(location.href);
    tell("The link is copied.");
  } catch {
    // No clipboard without a secure origin and the visitor's leave.
    showLink();
  }
});

fullScreenButton.hidden = !document.fullscreenEnabled;
fullScreenButton.addEventListener("click", () => {
  const change = document.fullscreenElement
    ? document.exitFullscreen()
    : document.documentElement.requestFullscreen();
  change.catch(() => {}); // the browser tells the visitor itself
});
document.addEventListener("fullscreenchange", () => {
  fullScreenButton.setAttribute("aria-pressed", String(document.fullscreenElement !== null));
});

const fields = find(settings, "fieldset", HTMLFieldSetElement);
addSettings(room, fields, [...SHOWN, "sensitivity", "motion"]);
find(stage, ".settings-button", HTMLButtonElement).addEventListener("click", () => {
  show(settings);
  document.body.classList.add("settings-open");
});
settings.addEventListener("close", () => document.body.classList.remove("settings-open"));

bindMicrophone(room, find(settings, ".microphone", HTMLElement));

let toggleLab: Promise<() => void> | null = null;
labButton.addEventListener("click", async () => {
  if (labButton.hasAttribute("aria-busy")) return; // two clicks ask for one lab
  labButton.setAttribute("aria-busy", "true");
  toggleLab ??= import("./lab/lab.js").then(({ addLab }) => addLab(room, stage, labButton));
  try {
    (await toggleLab)();
  } catch {
    toggleLab = null; // another click tries again, but some browsers keep what failed
    tell("The lab cannot be fetched. Try again, or reload the page.");
  } finally {
    labButton.removeAttribute("aria-busy");
  }
});
