// The secret of the program's run, which every request for more than the page's own files names.
//
// It comes in the page's address behind the #, as a browser sends to nobody what stands there. It is taken out of the address, so that it is not seen, nor copied with it, and is
// kept for this tab, so that the page can be loaded anew.

const key = "dioptre-token";

/** Takes the token out of the page's address; says whether one was there. */
export function takeToken() {
  const token = new URLSearchParams(location.hash.slice(1)).get("token");
  if (token === null) return false;
  sessionStorage.setItem(key, token);
  history.replaceState(null, "", location.pathname);
  return true;
}

/** The address of something of the program's, with the token. */
export function withToken(path) {
  const address = new URL(path, location.origin);
  address.searchParams.set("token", sessionStorage.getItem(key) ?? "");
  return address;
}
