"""Pages of the site (host/mkdocs.yml) from the repository's documents, and a check of the links in what mkdocs makes of them.

site.py stage ROOT SITE    copies every document, and every file that one links to, into SITE/pages; mkdocs.yml beside it
site.py check HTML         follows every link from page to page, to files and to places on pages, and looks for pages of host/docs that the navigation lacks; exit code 1 if something is wrong
"""
import html.parser
import pathlib
import re
import shutil
import sys
import urllib.parse

FOLDERS = ("host", "kernels", "bench", "scenes", "tests", ".github")
LINK = re.compile(r"(!?)\[([^\]]*)\]\(([^)\s]+)\)")
STYLE = """.wy-nav-content { max-width: 1100px; }
.wy-table-responsive table td, .wy-table-responsive table th { white-space: normal; vertical-align: top; }
.rst-content img { max-width: 100%; }
"""
# Debian's mkdocs 1.4 has the theme's pages ask for two scripts that its package lacks: jQuery, which stands elsewhere, and one that gives tables their looks.
JQUERY = pathlib.Path("/usr/share/javascript/jquery/jquery.min.js")
TABLES = """document.addEventListener("DOMContentLoaded", () => {
  for (const table of document.querySelectorAll(".rst-content table")) table.classList.add("docutils");
});
"""


def place(path):
    """Where a file of the repository stands on the site: folders whose name begins with a dot would be left out."""
    return pathlib.PurePosixPath(str(path).replace(".github", "github", 1))


def documents(root):
    yield pathlib.PurePosixPath("README.md")
    for folder in FOLDERS:
        for file in sorted((root / folder).rglob("*.md")):
            yield pathlib.PurePosixPath(file.relative_to(root).as_posix())


def stage(root, site):
    pages = site / "pages"
    shutil.rmtree(pages, ignore_errors=True)
    needed = set()

    def link(page):
        def replaced(match):
            mark, text, target = match.groups()
            path, hash_, anchor = target.partition("#")
            if "://" in target or not path:
                return match.group(0)
            file = (root / page.parent / path).resolve()
            if file.is_dir():
                file = file / "README.md"
            if not file.is_file():
                return text  # a folder of source files has no page
            where = pathlib.PurePosixPath(file.relative_to(root).as_posix())
            if where.suffix != ".md":
                needed.add(where)
            up = "../" * len(place(page).parent.parts)
            return f"{mark}[{text}]({up}{place(where)}{hash_}{anchor})"

        return replaced

    for page in documents(root):
        target = pages / place(page)
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(LINK.sub(link(page), (root / page).read_text(encoding="utf-8")), encoding="utf-8")
    for file in needed:
        (pages / place(file)).parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(root / file, pages / place(file))
    (pages / "site.css").write_text(STYLE)
    (pages / "js").mkdir()
    (pages / "js/theme_extra.js").write_text(TABLES)
    shutil.copyfile(JQUERY, pages / "js/jquery-3.6.0.min.js")
    text = (root / "host/mkdocs.yml").read_text(encoding="utf-8")
    (site / "mkdocs.yml").write_text(text.replace("../build/site/", ""), encoding="utf-8")


class Page(html.parser.HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.places, self.links = set(), []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        given = dict(attributes)
        self.places.update(value for key, value in given.items() if key in ("id", "name") and value)
        self.links += [given[key] for key in ("href", "src") if given.get(key)]


def check(folder):
    pages = {file.resolve(): Page(file.read_text(encoding="utf-8")) for file in folder.rglob("*.html") if file.name not in ("404.html", "search.html")}
    wrong = 0
    for file, page in pages.items():
        for target in page.links:
            url = urllib.parse.urlsplit(target)
            if url.scheme or url.netloc:
                continue
            to = (file.parent / urllib.parse.unquote(url.path)).resolve() if url.path else file
            place_ = urllib.parse.unquote(url.fragment)
            if not to.exists() or (place_ and to in pages and place_ not in pages[to].places):
                print(f"{file.relative_to(folder.resolve())}: the link to {target} leads nowhere", file=sys.stderr)
                wrong += 1
    for file in sorted((folder / "host/docs").glob("*.html")):
        if file.relative_to(folder).as_posix() not in pages[(folder / "index.html").resolve()].links:
            print(f"{file.relative_to(folder)}: is not in the navigation of host/mkdocs.yml", file=sys.stderr)
            wrong += 1
    print(f"{len(pages)} pages, {sum(len(p.links) for p in pages.values())} links, {wrong} mistakes", file=sys.stderr)
    return 1 if wrong or len(pages) < 40 else 0


if __name__ == "__main__":
    if sys.argv[1] == "stage":
        stage(pathlib.Path(sys.argv[2]).resolve(), pathlib.Path(sys.argv[3]))
    else:
        sys.exit(check(pathlib.Path(sys.argv[2])))
