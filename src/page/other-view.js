// A classic script, before anything is shown: whoever comes by a link to another view gets no poster of the
// first one. Only the quality, of all that a link may name (share-link.ts), leaves the view as it is.
if (!/^#?(quality=\w+)?$/.test(location.hash)) {
  document.documentElement.classList.add("other-view");
}
