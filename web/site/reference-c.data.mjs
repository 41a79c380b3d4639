import { cHeaders } from "../tools/site/c-reference.mjs";

export default { watch: ["../../bindings/api.json"], load: cHeaders };
