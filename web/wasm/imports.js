// imports.js: a JavaScript library for emcc that declares the imports of the module: `thud_clock`,
// and the callbacks of listeners, filters, casts and steps. These functions are never called: the
// package passes its own when it instantiates the module (web/package/src/engine.ts).
mergeInto(LibraryManager.library, {
  thud_clock: function () { return 0; },
  thud_asked: function () {},
  thud_told: function () {},
  thud_told_body: function () {},
  thud_told_category: function () {},
  thud_filtered: function () { return 1; },
  thud_stepped: function () {},
  thud_cast_hit: function () { return 1; },
});
