"""What is open, changed, saved and closed."""

from __future__ import annotations

import os

from lsprotocol import types

from launchlint.server.addresses import path_of
from launchlint.server.service import Service

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.server.positions import Unit

WATCHED = (
    "**/*.{launch,test,xml,yaml,yml,py,cpp,cc,cxx,h,hpp,cfg,msg,srv,action,cmake,repos,rosinstall}",
    "**/CMakeLists.txt",
    "**/.launchlint.yaml",
)

_UNITS: dict[str, Unit] = {types.PositionEncodingKind.Utf8: "utf-8", types.PositionEncodingKind.Utf32: "utf-32"}


def register(server: Service) -> None:
    """Take part in the life of documents."""

    @server.feature(types.INITIALIZE)
    def initialize(params: types.InitializeParams) -> None:
        folders = [each.uri for each in params.workspace_folders or ()] or ([params.root_uri] if params.root_uri else [])
        server.folders = [path for path in map(path_of, folders) if path is not None]

    @server.feature(types.INITIALIZED)
    def initialized(params: types.InitializedParams) -> None:
        server.documents.unit = _UNITS.get(server.workspace.position_encoding or "", "utf-16")
        able = server.client_capabilities.workspace
        watches = None if able is None else able.did_change_watched_files
        if watches is not None and watches.dynamic_registration:
            watchers = [types.FileSystemWatcher(glob_pattern=each) for each in WATCHED]
            options = types.DidChangeWatchedFilesRegistrationOptions(watchers)
            server.client_register_capability(
                types.RegistrationParams([types.Registration("launchlint-files", types.WORKSPACE_DID_CHANGE_WATCHED_FILES, options)])
            )

    @server.feature(types.TEXT_DOCUMENT_DID_OPEN)
    async def did_open(params: types.DidOpenTextDocumentParams) -> None:
        given = params.text_document
        file = path_of(given.uri)
        if file is None:
            return
        document = server.documents.open(given.uri, file, given.text, given.version)
        server.analysis_of(file).hold(file, document.data, document.version)

    @server.feature(types.TEXT_DOCUMENT_DID_CHANGE)
    async def did_change(params: types.DidChangeTextDocumentParams) -> None:
        document = server.document(params.text_document.uri)
        if document is not None:
            document.change(list(params.content_changes), params.text_document.version)
            server.analysis_of(document.file).hold(document.file, document.data, document.version)

    @server.feature(types.TEXT_DOCUMENT_DID_SAVE)
    async def did_save(params: types.DidSaveTextDocumentParams) -> None:
        file = path_of(params.text_document.uri)
        if file is not None:
            server.analysis_of(file)
            server.written([file])

    @server.feature(types.TEXT_DOCUMENT_DID_CLOSE)
    async def did_close(params: types.DidCloseTextDocumentParams) -> None:
        document = server.document(params.text_document.uri)
        if document is not None:
            server.forget(document)
            server.documents.close(document.file)
            server.analysis_of(document.file).hold(document.file, None, 0)

    @server.feature(types.WORKSPACE_DID_CHANGE_WATCHED_FILES)
    async def did_change_watched_files(params: types.DidChangeWatchedFilesParams) -> None:
        files = [path for path in (path_of(each.uri) for each in params.changes) if path is not None]
        server.written([file for file in files if f"{os.sep}.git{os.sep}" not in file])

    @server.feature(types.WORKSPACE_DID_CHANGE_WORKSPACE_FOLDERS)
    def did_change_workspace_folders(params: types.DidChangeWorkspaceFoldersParams) -> None:
        gone = {path_of(each.uri) for each in params.event.removed}
        server.folders = [each for each in server.folders if each not in gone]
        server.folders += [path for path in (path_of(each.uri) for each in params.event.added) if path is not None]

    @server.feature(types.SHUTDOWN)
    def shutdown(*_: object) -> None:
        server.end()
