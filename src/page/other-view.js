// A classic script, run before the first paint: removes the poster if the link is to another view than the poster's.
// Of a link's settings (share-link.ts), only the quality does not change the view.
if (!/^#?(quality=\w+)?$/.test(location.hash)) {
  document.documentElement.classList.add("other-view");
}
