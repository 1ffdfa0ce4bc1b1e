// A classic script, before anything is drawn: a link to another view gets no poster of the first one. Of all
// settings of a link (share-link.ts), only the quality leaves the view as it is.
if (!/^#?(quality=\w+)?$/.test(location.hash)) {
  document.documentElement.classList.add("other-view");
}
