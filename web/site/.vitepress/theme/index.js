/** The site's theme: that of VitePress in the page's colours, with examples that run. */
import DefaultTheme from "vitepress/theme-without-fonts";
import Home from "./Home.vue";
import Lab from "./Lab.vue";
import Layout from "./Layout.vue";
import Live from "./Live.vue";
import Prices from "./Prices.vue";
import Scene from "./Scene.vue";
import "./style.css";

export default {
  extends: DefaultTheme,
  Layout,
  enhanceApp({ app }) {
    app.component("Home", Home);
    app.component("Lab", Lab);
    app.component("Live", Live);
    app.component("Prices", Prices);
    app.component("Scene", Scene);
  },
};
