// The replay of the runs. A stub until it is written.

export async function createReplay(element) {
  element.textContent = "The replay is not part of this page yet.";
  return { destroy() {} };
}
