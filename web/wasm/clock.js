// clock.js: declares the one import of ours, `thud_clock`, to the linker. It is never run: the
// package brings the function itself (web/package/src/module.ts).
mergeInto(LibraryManager.library, { thud_clock: function () { return 0; } });
