// Every word of the page, in English and, beside it, in French.
//
// A word is a text, or a function of what it tells. In French the spaces before : ; ? ! and within « » are made unbreakable by `typeset`, so that the texts can be written with
// plain ones.

const words = {
  // The page
  skip: ["To the picture", "Aller à l’image"],
  text: ["The scene’s text", "Le texte de la scène"],
  picture: ["Picture", "Image"],
  before: ["Before", "Avant"],
  now: ["Now", "Maintenant"],
  save: ["Save", "Enregistrer"],
  saveHint: ["Save to the scene’s file (Ctrl+S)", "Enregistrer dans le fichier de la scène (Ctrl+S)"],
  saved: ["saved", "enregistré"],
  unsaved: ["not saved", "non enregistré"],
  language: ["Français", "English"],
  languageHint: ["En français", "In English"],
  theme: ["Light or dark", "Clair ou sombre"],
  keys: ["Keys", "Touches"],
  close: ["Close", "Fermer"],

  // The picture
  tools: ["View of the picture", "Vue de l’image"],
  zoomIn: ["Closer (+)", "Plus près (+)"],
  zoomOut: ["Farther (-)", "Plus loin (-)"],
  zoomFit: ["Fit", "Entière"],
  zoomFitHint: ["The whole picture (0)", "L’image entière (0)"],
  compare: ["Comparison with the picture before", "Comparaison avec l’image d’avant"],
  compareOff: ["One picture", "Une image"],
  compareSide: ["Side by side", "Côte à côte"],
  compareDifference: ["Differences", "Différences"],
  download: ["Download PNG", "Télécharger le PNG"],
  downloadHint: ["Download the picture as a PNG file", "Télécharger l’image comme fichier PNG"],
  canvas: [(w, h) => `Picture of ${w} by ${h} pixels. Arrow keys move from pixel to pixel, Enter tells why a pixel has its colour.`, (w, h) => `Image de ${w} sur ${h} pixels. Les flèches vont de pixel en pixel, Entrée raconte pourquoi un pixel a sa couleur.`],
  canvasBefore: ["The picture before", "L’image d’avant"],
  pixel: [(column, row) => `column ${column}, row ${row}`, (column, row) => `colonne ${column}, ligne ${row}`],
  pixelHint: ["Click on a pixel to see why it has its colour.", "Cliquez sur un pixel pour voir pourquoi il a sa couleur."],
  was: ["before", "avant"],
  none: ["no picture before this one yet", "pas encore d’image avant celle-ci"],
  sizes: [(a, b) => `the sizes differ: ${a} and ${b}`, (a, b) => `les tailles diffèrent : ${a} et ${b}`],
  same: ["no pixel differs", "aucun pixel ne diffère"],
  differ: [(n, share, largest, first) => `${n} ${n === "1" ? "pixel differs" : "pixels differ"} (${share}), by ${largest} of 255 at most, first at column ${first.column}, row ${first.row}`, (n, share, largest, first) => `${n} ${n === "1" ? "pixel diffère" : "pixels diffèrent"} (${share}), d’au plus ${largest} sur 255, le premier colonne ${first.column}, ligne ${first.row}`],
  waitToCompare: ["compared when the picture is finished", "comparaison quand l’image sera finie"],

  // What is going on
  connecting: ["Connecting…", "Connexion…"],
  drawing: ["Drawing…", "Dessin en cours…"],
  drawingFor: [(seconds, speed) => `Drawing for ${seconds} s, ${speed} rays per second`, (seconds, speed) => `Dessin depuis ${seconds} s, ${speed} rayons par seconde`],
  drawn: [(seconds, rays, speed) => `Drawn in ${seconds} s: ${rays} rays, ${speed} per second`, (seconds, rays, speed) => `Dessinée en ${seconds} s : ${rays} rayons, ${speed} par seconde`],
  cut: ["More rays were wanted than are followed.", "Plus de rayons étaient demandés qu’il n’en est suivi."],
  written: [(path) => `Written to ${path}.`, (path) => `Écrite dans ${path}.`],
  stopped: ["Stopped", "Arrêtée"],
  progress: ["How much of the picture is drawn", "Part dessinée de l’image"],
  faults: [(n) => (n === 0 ? "No faults" : n === 1 ? "1 fault" : `${n} faults`), (n) => (n === 0 ? "Aucune faute" : n === 1 ? "1 faute" : `${n} fautes`)],
  remarks: [(n) => (n === 1 ? "1 remark" : `${n} remarks`), (n) => (n === 1 ? "1 remarque" : `${n} remarques`)],
  lastGood: ["The text has faults. This is the last good picture.", "Le texte a des fautes. Voici la dernière bonne image."],
  drawAnyway: ["Draw anyway", "Dessiner quand même"],
  lost: ["The program has ended, or cannot be reached. What you type is kept here.", "Le programme s’est arrêté, ou ne répond pas. Ce que vous tapez est gardé ici."],
  refused: ["The program does not know this page’s token. Put the whole address that it printed into this tab; what you type here is kept.", "Le programme ne connaît pas le jeton de cette page. Mettez dans cet onglet l’adresse entière qu’il a affichée ; ce que vous tapez ici est gardé."],
  retry: ["Try now", "Réessayer"],
  conflict: ["The file was changed while the text here is not saved.", "Le fichier a changé, alors que le texte d’ici n’est pas enregistré."],
  reload: ["Take the file’s text", "Prendre le texte du fichier"],
  overwrite: ["Save this one over it", "Enregistrer celui-ci par-dessus"],
  tooLong: [(bytes, most) => `The text is too long for the viewer: ${bytes} bytes, at most ${most}.`, (bytes, most) => `Le texte est trop long pour la visionneuse : ${bytes} octets, au plus ${most}.`],
  place: [(line, column) => `line ${line}, column ${column}`, (line, column) => `ligne ${line}, colonne ${column}`],
  expected: ["expected", "attendu"],
  used: ["used", "utilisé"],

  // Keys
  keyList: [
    [["Ctrl+S", "Ctrl+S"], ["save", "enregistrer"]],
    [["Ctrl+Enter", "Ctrl+Entrée"], ["from the text to the picture", "du texte à l’image"]],
    [["Tab", "Tab"], ["on to the next part; in the text, too", "à la partie suivante ; dans le texte aussi"]],
    [["← ↑ → ↓", "← ↑ → ↓"], ["in the picture: one pixel on; with Shift ten", "dans l’image : un pixel plus loin ; avec Maj, dix"]],
    [["Enter", "Entrée"], ["in the picture: why has this pixel this colour?", "dans l’image : pourquoi ce pixel a-t-il cette couleur ?"]],
    [["+  -  0", "+  -  0"], ["closer, farther, the whole picture", "plus près, plus loin, l’image entière"]],
    [["Ctrl+wheel", "Ctrl+molette"], ["closer, farther", "plus près, plus loin"]],
    [["C", "C"], ["compare: one picture, side by side, differences", "comparer : une image, côte à côte, différences"]],
    [["E", "E"], ["from the picture to the text", "de l’image au texte"]],
    [["?", "?"], ["this list", "cette liste"]],
    [["Esc", "Échap"], ["close the story, or this list", "fermer l’histoire, ou cette liste"]],
  ],

  // Stories
  story: ["Why this colour?", "Pourquoi cette couleur ?"],
  storyOf: [(column, row) => `Pixel ${column}, ${row}`, (column, row) => `Pixel ${column}, ${row}`],
  stale: ["The text has changed since. This is about the picture before.", "Le texte a changé depuis. Ceci raconte l’image d’avant."],
  sees: [(shape) => `Its ray sees ${shape}.`, (shape) => `Son rayon voit : ${shape}.`],
  seesNothing: ["Its ray meets no shape.", "Son rayon ne rencontre aucune forme."],
  manyRays: [(n) => `${n} rays are cast through the pixel; its colour is their mean.`, (n) => `${n} rayons sont lancés à travers le pixel ; sa couleur est leur moyenne.`],
  through: [(k, x, y) => `Ray ${k}, through (${x}, ${y}) in the pixel`, (k, x, y) => `Rayon ${k}, en (${x}, ${y}) dans le pixel`],
  light: [(algorithm, level) => `Light: ${algorithm}, recursive_level ${level}.`, (algorithm, level) => `Lumière : ${algorithm}, recursive_level ${level}.`],
  ray: [(name) => `Ray ${name}`, (name) => `Rayon ${name}`],
  cause: {
    camera: ["from the camera", "de la caméra"],
    reflection: ["reflected", "réfléchi"],
    refraction: ["refracted", "réfracté"],
  },
  weight: ["weight", "poids"],
  index: ["refractive index", "indice de réfraction"],

  // Stories: shapes that a ray was tried on
  tried: [(n) => `Shapes it was tried on: ${n}`, (n) => `Formes essayées : ${n}`],
  others: [(n) => `${n} more beside its line`, (n) => (n === "1" ? "1 autre à côté de sa droite" : `${n} autres à côté de sa droite`)],
  untold: [(n) => `${n} more not told one by one`, (n) => (n === "1" ? "1 autre, non racontée" : `${n} autres, non racontées une à une`)],
  moreShapes: [(n) => `${n} more`, (n) => (n === 1 ? "1 autre" : `${n} autres`)],
  noShape: ["There is no shape.", "Il n’y a pas de forme."],
  primitive: [(n) => `primitive ${n}`, (n) => `primitive ${n}`],
  ofModel: [(part, model) => `shape ${part} of ${model}`, (part, model) => `forme ${part} de ${model}`],
  model: [(n) => `model ${n}`, (n) => `modèle ${n}`],
  transformed: ["transformed", "transformation appliquée"],
  kind: {
    plane: ["plane", "plan"],
    disk: ["disk", "disque"],
    annulus: ["annulus", "anneau"],
    sphere: ["sphere", "sphère"],
    cylinder: ["cylinder", "cylindre"],
    cone: ["cone", "cône"],
    lens: ["lens", "lentille"],
    spherical_cap: ["spherical cap", "calotte sphérique"],
    torus: ["torus", "tore"],
    btriangle: ["smooth triangle", "triangle lisse"],
  },
  quoted: [(name) => `‘${name}’`, (name) => `« ${name} »`],
  verdict: {
    closest: ["met, nothing is nearer", "rencontrée, rien n’est plus proche"],
    farther: ["met, something is nearer", "rencontrée, quelque chose est plus proche"],
    asNear: ["met, another as near comes first in the file", "rencontrée, une autre aussi proche la précède dans le fichier"],
    parallel: ["not met: parallel", "pas de rencontre : parallèle"],
    noRoot: ["not met: no real root", "pas de rencontre : pas de racine réelle"],
    notOnShape: ["not met: the line passes beside it", "pas de rencontre : la droite passe à côté"],
    behind: ["not met: behind the origin", "pas de rencontre : derrière l’origine"],
    tooNear: ["not met: only where the ray starts", "pas de rencontre : seulement là où le rayon part"],
    beyondFar: ["not met: beyond the far clipping plane", "pas de rencontre : au-delà du plan de coupure éloigné"],
  },
  ownFrame: ["in its own frame", "dans son repère"],
  patch: {
    plane: ["plane", "plan"],
    sphere: ["sphere", "sphère"],
    tube: ["tube without end", "tube sans fin"],
    cones: ["double cone without end", "double cône sans fin"],
    torus: ["torus", "tore"],
    ends: ["between the ends", "entre les extrémités"],
    "face at start": ["sphere of the face at P1", "sphère de la face en P1"],
    "face at end": ["sphere of the face at P2", "sphère de la face en P2"],
  },
  faces: [(axis) => `between the faces across ${axis}`, (axis) => `entre les faces perpendiculaires à ${axis}`],
  reach: [(distance, reach) => `The line passes ${distance} from the centre; the shape reaches as far as ${reach}.`, (distance, reach) => `La droite passe à ${distance} du centre ; la forme s’étend jusqu’à ${reach}.`],
  where: ["where", "où"],
  fate: {
    kept: ["kept", "gardée"],
    later: ["later", "plus tard"],
    behind: ["negative: behind the origin", "négative : derrière l’origine"],
    tooNear: ["too near: at most 1e-8", "trop proche : au plus 1e-8"],
    beyondFar: ["too far: beyond the far clipping plane", "trop loin : au-delà du plan de coupure éloigné"],
    outside: ["not on the shape", "pas sur la forme"],
  },
  elsewhere: ["another condition fails", "une autre condition manque"],
  measured: {
    radius: [(d, r) => `${d} from the centre, radius ${r}`, (d, r) => `à ${d} du centre, rayon ${r}`],
    innerRadius: [(d, r) => `${d} from the centre, in the hole of radius ${r}`, (d, r) => `à ${d} du centre, dans le trou de rayon ${r}`],
    height: [(h, l) => `at height ${h} of 0 to ${l}`, (h, l) => `à la hauteur ${h} de 0 à ${l}`],
  },
  numberLine: [(roots) => `Number line of t with the roots ${roots}`, (roots) => `Droite numérique de t, avec les racines ${roots}`],
  noRoots: ["Number line of t without roots", "Droite numérique de t, sans racine"],
  far: ["far", "loin"],
  origin: ["0", "0"],

  // Stories: light
  hit: ["Where the ray meets it", "Là où le rayon la rencontre"],
  point: ["point", "point"],
  normal: ["normal", "normale"],
  turned: ["turned to the ray", "tournée vers le rayon"],
  surface: ["Surface", "Surface"],
  ambient: ["ambient", "ambiant"],
  diffuse: ["diffuse", "diffus"],
  specular: ["specular", "spéculaire"],
  shininess: ["shininess", "brillance"],
  fromPicture: ["from its picture at uv", "de son image en uv"],
  lights: ["Light there", "Lumière à cet endroit"],
  noLights: ["There is no light in the scene.", "Il n’y a pas de lumière dans la scène."],
  unlit: ["Without light (no_light) the diffuse colour is seen as it is.", "Sans lumière (no_light), la couleur diffuse est vue telle quelle."],
  lightKind: {
    ambient: ["ambient light", "lumière ambiante"],
    directional: ["directional light", "lumière directionnelle"],
    point: ["point light", "lumière ponctuelle"],
    waves: ["light of waves", "lumière d’ondes"],
  },
  arrival: {
    everywhere: ["from everywhere", "de partout"],
    leftOut: ["left out by this algorithm", "laissée de côté par cet algorithme"],
    nowhere: ["nothing: its attenuation is not defined here", "rien : son atténuation n’est pas définie ici"],
    facesAway: ["nothing: the surface is turned away", "rien : la surface lui tourne le dos"],
    shadow: ["in shadow", "dans l’ombre"],
    arrives: ["arrives", "arrive"],
  },
  shadowOf: [(shape) => `in the shadow of ${shape}`, (shape) => `dans l’ombre de : ${shape}`],
  throughShapes: [(shapes) => `arrives through ${shapes}`, (shapes) => `arrive à travers : ${shapes}`],
  distance: ["distance", "distance"],
  attenuation: ["attenuation", "atténuation"],
  cosine: ["cosine", "cosinus"],
  times: ["times", "fois"],
  term: {
    ambient: ["ambient", "ambiant"],
    diffuse: ["diffuse", "diffus"],
    blinn: ["highlight", "reflet"],
    phong: ["highlight", "reflet"],
    waves: ["waves", "ondes"],
  },
  together: ["together", "ensemble"],

  // Stories: rays from a hit
  bounces: ["Rays from here", "Rayons qui en partent"],
  mirror: ["Mirror", "Miroir"],
  entering: ["Entering", "En entrant"],
  leaving: ["Leaving", "En sortant"],
  angleIn: ["in at", "arrivée à"],
  angleOut: ["out at", "départ à"],
  obstacle: {
    depth: ["recursive_level ends here", "recursive_level s’arrête ici"],
    tooManyRays: ["too many rays already", "déjà trop de rayons"],
    totalReflection: ["nothing passes: total reflection", "rien ne passe : réflexion totale"],
    noInside: ["the shape has no inside", "la forme n’a pas d’intérieur"],
  },
  meetsNothing: ["It meets nothing: black.", "Il ne rencontre rien : noir."],

  // Stories: colours, and the picture
  colour: ["From the sum to four bytes", "De la somme aux quatre octets"],
  mean: ["mean", "moyenne"],
  sum: ["sum", "somme"],
  andMore: [(n) => `and ${n} more`, (n) => `et ${n} de plus`],
  unchanged: ["no channel is above 1", "aucun canal ne dépasse 1"],
  normalized: ["at most 1", "au plus 1"],
  rounded: ["times 255, rounded", "fois 255, arrondi"],
  onPicture: ["On the picture", "Sur l’image"],
  legend: {
    reflection: ["reflected ray", "rayon réfléchi"],
    refraction: ["refracted ray", "rayon réfracté"],
    reached: ["light that arrives", "lumière qui arrive"],
    shadow: ["light in shadow", "lumière dans l’ombre"],
  },
  inWords: ["The same as text, with all digits", "Le même récit en texte, avec tous les chiffres"],
};

let language = navigator.language.startsWith("fr") ? "fr" : "en";

export const currentLanguage = () => language;
export const otherLanguage = () => (language === "fr" ? "en" : "fr");

/** A word in the language of the page, with what it tells. */
export const say = (key, ...told) => spoken(words[key], told);

/** A word of a table: what has none is called as the program calls it. */
export const sayIn = (table, key, ...told) => spoken(words[table][key] ?? [key, key], told);

/** The list of keys: pairs of a key and what it does. */
export const keyList = () => words.keyList.map((pair) => pair.map((word) => spoken(word, [])));

function spoken([english, french], told) {
  const word = language === "fr" ? french : english;
  return typeset(typeof word === "function" ? word(...told) : word);
}

/** A number in words of the language: 1,234.5 or 1 234,5. */
export const counted = (x, digits = 0) => x.toLocaleString(language, { maximumFractionDigits: digits });

/** Seconds, with as many digits as can be read. */
export const seconds = (x) => x.toLocaleString(language, x < 10 ? { minimumFractionDigits: 2, maximumFractionDigits: 2 } : { maximumFractionDigits: 1 });

/** A share of a whole in percent. */
export const percent = (x) => x.toLocaleString(language, { style: "percent", maximumSignificantDigits: 2 });

/** French spaces before : ; ? ! and within « ». */
function typeset(text) {
  if (language !== "fr") return text;
  return text.replace(/ :/g, "\u00a0:").replace(/ ([;?!])/g, "\u202f$1").replace(/« /g, "«\u00a0").replace(/ »/g, "\u00a0»");
}

/** Speaks another language from now on: the page's fixed words are put in anew. `data-word` names the text of an element, `data-label` its label and title. */
export function speak(next) {
  language = next === "fr" ? "fr" : "en";
  document.documentElement.lang = language;
  for (const one of document.querySelectorAll("[data-word]")) one.textContent = say(one.dataset.word);
  for (const one of document.querySelectorAll("[data-label]")) one.setAttribute("aria-label", say(one.dataset.label));
  for (const one of document.querySelectorAll("[data-hint]")) one.title = say(one.dataset.hint);
}
