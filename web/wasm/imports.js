// imports.js: declares our imports to the linker: `thud_clock`, and the callbacks of listeners,
// filters, casts and steps. None is ever run: the package brings the functions itself (web/package/src/engine.ts).
mergeInto(LibraryManager.library, {
  thud_clock: function () { return 0; },
  thud_asked: function () {},
  thud_told: function () {},
  thud_filtered: function () { return 1; },
  thud_stepped: function () {},
  thud_met: function () { return 1; },
});
