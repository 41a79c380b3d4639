/**
 * By the name of a scene, more words that the search in the gallery finds it by: what textbooks and
 * lectures call the idea that it shows, where its title and description say it in other words.
 */
export const KEYWORDS: Readonly<Record<string, string>> = {
  bullets: "tunnelling tunneling fast paper time step continuous collision detection ccd",
  broadphases: "plane sweep and prune sap sorted lists insertion sort spatial hash cell size",
  detection:
    "collision detection tunnelling tunneling ccd intersection testing bisection capsules extruded " +
    "circles swept volumes error over time price cost",
  geometry:
    "collision detection normal depth penetration signed distance closest points time of impact " +
    "intersection testing bounding volumes",
  asleep: "numerical stability at the extremes",
  artillery: "multiplayer together friend network webrtc link qr code rollback netcode two players",
  far_away: "numerical stability at the extremes large coordinates precision rounding",
  heavy_on_light: "numerical stability at the extremes mass ratios",
  minkowski: "point against shape configuration space difference",
  one_spot: "grid cell size broadphase numerical stability at the extremes",
  playground: "complex shapes made up of boxes approximation compound",
  sumo:
    "multiplayer together friend network webrtc link qr code rollback netcode latency two players four " +
    "joints wheels",
  sizes: "grid cell size broadphase numerical stability at the extremes",
  textured: "terrain foot feet friction uv coordinates barycentric weights interpolation",
  lab_approximate:
    "complex shapes approximated by simple shapes made up of circles and boxes approximation " +
    "compound polygon area wasted hausdorff bound error over count",
  lab_bisection:
    "overlap testing time of collision halvings halving tunnelling tunneling speed time step thickness",
  lab_broadphase:
    "n^2 n² n squared grid cell size plane sweep and prune sap sorted lists insertion sort counted " +
    "counts of tests counting",
  lab_callbacks:
    "callbacks listeners events pre-solve post-solve presolve postsolve veto does the pair " +
    "collide kicker bumper portal velocities one to each object",
  lab_capsule: "swept sphere stadium rounded segment capsule normal depth signed distance closest points",
  lab_latency:
    "network prediction dead reckoning swept prediction rollback lag delay peers extrapolation",
  lab_microscope:
    "collision microscope resolution four steps overlap response impulse contact manifold normal " +
    "depth penetration solver",
  lab_minkowski: "point against shape configuration space difference capsule rounded extruded",
  lab_prices:
    "collision detection overlap bisection swept continuous accuracy efficiency error over time price " +
    "cost frequency hertz 60 hz 120 hz 240 hz 480 hz 960 hz tolerance which method to choose",
  lab_swept:
    "intersection testing time of impact times of impact quadratic equation roots discriminant " +
    "parabola trajectory projectile sagitta capsule extruded circle ccd continuous",
  lab_terrain:
    "height field flat uniform irregular line barycentric weights interpolation foot feet " +
    "placed friction texture binary search",
  lab_volumes:
    "bounding sphere box proxy area wasted false positives complex shapes approximated by circles " +
    "boxes approximation",
};

/**
 * By the name of a scene, a part of a panel that answers what these words ask: a search that finds
 * the scene by them opens it. `id`: of an element of the panel.
 */
export const PARTS: Readonly<Record<string, { panel: string; id: string; words: string }>> = {
  detection: {
    panel: "trade",
    id: "measure-heading",
    words:
      "advice model only what does my a scene requires which speed against accuracy trade setting " +
      "quality method to choose cheapest",
  },
};
