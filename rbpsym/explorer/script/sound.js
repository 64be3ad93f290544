// The motion by ear: the pitch follows the first of the curves, left and right the first body; silent until it is asked for.

const LOW = 220, OCTAVES = 2, LOUD = 0.08, FADES = 0.15;
const sound = { phase: 0 };

function listening(is) {
  if (!is) { if (sound.context) sound.context.close(); sound.context = null; return; }
  const context = new AudioContext(), pan = context.createStereoPanner(), gain = context.createGain(), tone = context.createOscillator();
  gain.gain.value = 0;
  tone.connect(gain).connect(pan).connect(context.destination);
  tone.start();
  Object.assign(sound, { context, pan, gain, tone });
  hear();
}

/** The tone of this moment; it fades where nothing follows. A phase that begins is told by a high one. */
function hear() {
  const line = sound.context && state.curves && state.curves.lines[0];
  if (!line) return;
  const moment = line.motion.at(Math.min(state.time, line.motion.duration)), [, bottom, , top] = state.curves.box, now = sound.context.currentTime;
  const share = (line.of(moment) - bottom) / (top - bottom || 1), begins = moment.phase !== sound.phase, [x] = state.drawings[0].scale.point(pick(moment.data.bodies[0].cm, moment.out));
  sound.phase = moment.phase;
  if (!Number.isFinite(share)) return;
  const pitch = begins ? 8 * LOW : LOW * 2 ** (OCTAVES * Math.min(1, Math.max(0, share)));
  sound.tone.frequency.setTargetAtTime(pitch, now, 0.02);
  sound.pan.pan.value = Math.max(-1, Math.min(1, (2 * x) / ROOM - 1));
  sound.gain.gain.cancelScheduledValues(now);
  sound.gain.gain.setTargetAtTime(LOUD, now, 0.02);
  sound.gain.gain.setTargetAtTime(0, now + FADES, 0.05);
  document.documentElement.dataset.pitch = pitch.toFixed(1);
}
