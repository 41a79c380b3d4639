/** The pages of the site in reading order. A test asks that every page stands here. */
const page = (text, name) => ({ text, link: `/${name}` });

export const sidebar = [
  {
    text: "Begin",
    items: [
      page("In JavaScript", "begin-javascript"),
      page("In C", "begin-c"),
      page("In Python", "begin-python"),
    ],
  },
];
