// Can this browser draw in three dimensions? Asked once; without it the rest of the page works.

let answer = null;

export function canDraw3d() {
  if (answer !== null) return answer;
  try {
    const context = document.createElement("canvas").getContext("webgl2");
    answer = Boolean(context);
    context?.getExtension("WEBGL_lose_context")?.loseContext();
  } catch {
    answer = false;
  }
  return answer;
}
