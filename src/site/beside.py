"""Lays what the pages link to outside docs/ beside them, under repository/, so that links are the same on the site and in the repository.

A hook of MkDocs (mkdocs.yml). Markdown becomes a page, any other file is copied as it is. Where `mvn -Prelease package` has made the
Javadoc, it is copied to javadoc/.
"""

import posixpath
import re
import shutil
from pathlib import Path

from mkdocs.structure.files import File

ROOT = Path(__file__).resolve().parents[2]
DOCS = ROOT / "docs"
JAVADOC = ROOT / "target" / "reports" / "apidocs"
LINK = re.compile(r"(\]\()([^)\s#:]+)((?:#[^)\s]*)?\))")  # no address of another host has come without a colon
CODE = re.compile(r"^```.*?^```|`[^`\n]*`", re.MULTILINE | re.DOTALL)


def outside_code(markdown, replaced):
    """Replaces links, but none that only stands in code."""
    pieces, end = [], 0
    for code in CODE.finditer(markdown):
        pieces += [LINK.sub(replaced, markdown[end:code.start()]), code.group()]
        end = code.end()
    return "".join(pieces) + LINK.sub(replaced, markdown[end:])


def address(file):
    """Where a file of the repository stands on the site."""
    return file.relative_to(DOCS).as_posix() if file.is_relative_to(DOCS) else "repository/" + file.relative_to(ROOT).as_posix()


def on_files(files, config):
    unread = [Path(file.abs_src_path) for file in files.documentation_pages()]
    unread += [ROOT / name for name in ("README.md", "CONTRIBUTING.md", "CHANGELOG.md")]
    seen = set()
    while unread:
        page = unread.pop()
        if page in seen:
            continue
        seen.add(page)
        if not page.is_relative_to(DOCS):
            files.append(File.generated(config, address(page), abs_src_path=str(page)))
        if page.suffix == ".md":
            text = CODE.sub("", page.read_text(encoding="utf-8"))
            linked = [(page.parent / link.group(2)).resolve() for link in LINK.finditer(text)]
            unread += [file for file in linked if file.is_file() and not file.is_relative_to(DOCS)]
    return files


def on_page_markdown(markdown, page, config, files):
    file = Path(page.file.abs_src_path)

    def moved(link):
        target = (file.parent / link.group(2)).resolve()
        if not target.is_relative_to(ROOT):
            return link.group()
        return link.group(1) + posixpath.relpath(address(target), posixpath.dirname(page.file.src_uri)) + link.group(3)

    if page.file.src_uri == "reference/java.md" and JAVADOC.is_dir():
        markdown += '\n<a class="md-button" href="../javadoc/index.html">The Javadoc of this version</a>\n'
    return outside_code(markdown, moved)


def on_page_content(html, page, config, files):
    """A pipe in the code of a table's cell has a backslash for GitHub, which Python-Markdown would show."""
    return re.sub(r"^<td.*</td>$", lambda cell: cell.group().replace("\\|", "|"), html, flags=re.MULTILINE)


def on_post_build(config):
    if JAVADOC.is_dir():
        shutil.copytree(JAVADOC, Path(config.site_dir) / "javadoc", dirs_exist_ok=True)
