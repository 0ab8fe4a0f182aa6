// Operability: up to which wave height does a ship keep within limits? Linear theory: everything
// grows with Hs, so the height at which a limit is reached follows from one of 1 m. Pure.

/**
 * For each heading the greatest Hs within all limits, and which limit is reached first.
 * @param criteria [{limit, perMetre: [value at Hs = 1 m of each heading]}]
 */
export function limitingHeights(criteria, headings) {
  return headings.map((_, i) => {
    let hs = Infinity, by = -1;
    criteria.forEach(({ limit, perMetre }, which) => {
      const reached = limit / perMetre[i];
      if (reached < hs) [hs, by] = [reached, which];
    });
    return { hs, by };
  });
}

/** Share of headings, 0..1, that keep within the limits at each Hs. */
export function shareOfHeadings(limiting, heights) {
  return heights.map((hs) =>
    limiting.filter((heading) => heading.hs >= hs).length / limiting.length);
}
