// Written by `npm run schema` from `dripfeed openapi`: do not change it by hand.
export interface paths {
    "/healthz": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * is the server alive
         * @description Needs no token.
         */
        get: operations["get_healthz"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/metrics": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * what lines and server do, for Prometheus (text format 0.0.4)
         * @description Needs the role `viewer`.
         */
        get: operations["get_metrics"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/openapi.json": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * this description
         * @description Needs no token.
         */
        get: operations["get_api_openapi_json"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * the page
         * @description Needs no token.
         */
        get: operations["get_page"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/assets/{name}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * a file of the page
         * @description Needs no token.
         */
        get: operations["get_assets_name"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/docs": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * the documentation
         * @description Needs no token.
         */
        get: operations["get_docs"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/docs/{name}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * a page of the documentation, or its picture
         * @description Needs no token.
         */
        get: operations["get_docs_name"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/session": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * who am I
         * @description Needs the role `viewer`.
         */
        get: operations["get_session"];
        put?: never;
        /**
         * sign in with a token, or a name with a password or PIN; get a cookie
         * @description Needs no token.
         */
        post: operations["post_session"];
        /**
         * sign out
         * @description Needs the role `viewer`. A token with scopes needs `line`. Takes effect once under an `Idempotency-Key`.
         */
        delete: operations["delete_session"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/session/password": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        /**
         * a new password of one's own
         * @description Needs the role `viewer`. A token with scopes needs `line`.
         */
        put: operations["put_session_password"];
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/session/provider": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * the OpenID Connect provider that people may sign in by, as its button has it
         * @description Needs no token.
         */
        get: operations["get_session_provider"];
        put?: never;
        /**
         * sign in by what the provider sent back with the browser that began it; get a cookie
         * @description Needs no token.
         */
        post: operations["post_session_provider"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/session/provider/begin": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * begin to sign in by the provider: the address that the browser opens, and a cookie that it keeps meanwhile
         * @description Needs no token.
         */
        post: operations["post_session_provider_begin"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/events": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * live events, resumable (text/event-stream)
         * @description Needs the role `viewer`.
         */
        get: operations["get_events"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/mtconnect/probe": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * machines with their data items, for MTConnect (2.0)
         * @description Needs the role `viewer`.
         */
        get: operations["get_mtconnect_probe"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/mtconnect/current": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * the newest value of each data item
         * @description Needs the role `viewer`.
         */
        get: operations["get_mtconnect_current"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/mtconnect/sample": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * changes of data items, from a number on
         * @description Needs the role `viewer`.
         */
        get: operations["get_mtconnect_sample"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/mtconnect/assets": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * released programs as files
         * @description Needs the role `viewer`.
         */
        get: operations["get_mtconnect_assets"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/mtconnect/{name}/probe": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * one machine with its data items
         * @description Needs the role `viewer`.
         */
        get: operations["get_mtconnect_name_probe"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/mtconnect/{name}/current": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * the newest values of one machine
         * @description Needs the role `viewer`.
         */
        get: operations["get_mtconnect_name_current"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/mtconnect/{name}/sample": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * changes of one machine, from a number on
         * @description Needs the role `viewer`.
         */
        get: operations["get_mtconnect_name_sample"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/machines": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * machines with the state of their lines
         * @description Needs the role `viewer`. The next page is `after` the `next` of this one.
         */
        get: operations["get_machines"];
        put?: never;
        /**
         * add a machine by its profile
         * @description Needs the role `admin`. A token with scopes needs `setup`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_machines"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/machines/{name}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * one machine with its profile
         * @description Needs the role `viewer`.
         */
        get: operations["get_machines_name"];
        /**
         * change a profile
         * @description Needs the role `admin`. A token with scopes needs `setup`. Takes effect once under an `Idempotency-Key`. Changes the revision that `If-Match` names.
         */
        put: operations["put_machines_name"];
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/machines/{name}/utilisation": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * how its line was used, by days
         * @description Needs the role `viewer`.
         */
        get: operations["get_machines_name_utilisation"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/machines/{name}/wire": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * what passes on its line from now on, in both directions (text/event-stream, events `wire`)
         * @description Needs the role `viewer`.
         */
        get: operations["get_machines_name_wire"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/machines/{name}/line-test": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * measure its line with a loopback plug in the control's place; nothing is armed on it meanwhile
         * @description Needs the role `operator`. A token with scopes needs `line`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_machines_name_line_test"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/machines/{name}/confirm-reset": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * a person confirms that the control was reset
         * @description Needs the role `operator`. A token with scopes needs `line`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_machines_name_confirm_reset"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/machines/{name}/hand-over": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * give its line to another server of this store; nothing is on it
         * @description Needs the role `admin`. A token with scopes needs `setup`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_machines_name_hand_over"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/machines/{name}/take-over": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * a person takes its line over from a server that no longer answers
         * @description Needs the role `admin`. A token with scopes needs `setup`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_machines_name_take_over"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/nodes": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * servers that share this store; none: this is the only one
         * @description Needs the role `viewer`.
         */
        get: operations["get_nodes"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/groups": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * groups of machines
         * @description Needs the role `viewer`.
         */
        get: operations["get_groups"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/groups/{name}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        /**
         * make a group of machines, or change it as a whole
         * @description Needs the role `admin`. A token with scopes needs `setup`. Takes effect once under an `Idempotency-Key`.
         */
        put: operations["put_groups_name"];
        post?: never;
        /**
         * remove a group and what was granted in it
         * @description Needs the role `admin`. A token with scopes needs `setup`. Takes effect once under an `Idempotency-Key`.
         */
        delete: operations["delete_groups_name"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/groups/{name}/jobs": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * queue a program for the machines of a group: a choice of jobs of which a person arms one
         * @description Needs the role `operator`. A token with scopes needs `queue`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_groups_name_jobs"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/users": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * people
         * @description Needs the role `admin`. The next page is `after` the `next` of this one.
         */
        get: operations["get_users"];
        put?: never;
        /**
         * add a person
         * @description Needs the role `admin`. A token with scopes needs `setup`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_users"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/users/{name}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * one person
         * @description Needs the role `admin`.
         */
        get: operations["get_users_name"];
        /**
         * change roles, disable or enable
         * @description Needs the role `admin`. A token with scopes needs `setup`. Takes effect once under an `Idempotency-Key`. Changes the revision that `If-Match` names.
         */
        put: operations["put_users_name"];
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/users/{name}/unlock": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * end the lock after too many wrong secrets
         * @description Needs the role `admin`. A token with scopes needs `setup`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_users_name_unlock"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/users/{name}/password": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        /**
         * give a person a new password; ends sessions
         * @description Needs the role `admin`. A token with scopes needs `setup`.
         */
        put: operations["put_users_name_password"];
        post?: never;
        /**
         * take a password away; ends sessions
         * @description Needs the role `admin`. A token with scopes needs `setup`.
         */
        delete: operations["delete_users_name_password"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/users/{name}/pin": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        /**
         * give a person a new PIN for the shop floor; ends sessions
         * @description Needs the role `admin`. A token with scopes needs `setup`.
         */
        put: operations["put_users_name_pin"];
        post?: never;
        /**
         * take a PIN away; ends sessions
         * @description Needs the role `admin`. A token with scopes needs `setup`.
         */
        delete: operations["delete_users_name_pin"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/tokens": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * tokens, newest first, without their secrets
         * @description Needs the role `admin`. The next page is `after` the `next` of this one.
         */
        get: operations["get_tokens"];
        put?: never;
        /**
         * make a token; its secret is shown this once
         * @description Needs the role `admin`. A token with scopes needs `setup`.
         */
        post: operations["post_tokens"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/tokens/{id}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * one token, without its secret
         * @description Needs the role `admin`.
         */
        get: operations["get_tokens_id"];
        put?: never;
        post?: never;
        /**
         * end a token and its sessions
         * @description Needs the role `admin`. A token with scopes needs `setup`. Takes effect once under an `Idempotency-Key`.
         */
        delete: operations["delete_tokens_id"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/audit": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * who did what, newest first
         * @description Needs the role `approver`. The next page is `after` the `next` of this one.
         */
        get: operations["get_audit"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/store": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * where the store is and what room it has
         * @description Needs the role `admin`.
         */
        get: operations["get_store"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/store/verify": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * read the whole store through: the audit's chain, each ledger, each text by its hash
         * @description Needs the role `admin`. A token with scopes needs `setup`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_store_verify"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/backups": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * backups in the server's folder for them, newest first
         * @description Needs the role `admin`.
         */
        get: operations["get_backups"];
        put?: never;
        /**
         * make a backup of the whole store while it runs; it is read back as a whole before it gets its name
         * @description Needs the role `admin`. A token with scopes needs `setup`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_backups"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/backups/{name}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        post?: never;
        /**
         * remove a backup
         * @description Needs the role `admin`. A token with scopes needs `setup`. Takes effect once under an `Idempotency-Key`.
         */
        delete: operations["delete_backups_name"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/families": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * part families
         * @description Needs the role `viewer`. The next page is `after` the `next` of this one.
         */
        get: operations["get_families"];
        put?: never;
        /**
         * add a family by its text
         * @description Needs the role `programmer`. A token with scopes needs `library`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_families"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/families/{name}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * one family with its text and parameters
         * @description Needs the role `viewer`.
         */
        get: operations["get_families_name"];
        /**
         * a new revision of a family
         * @description Needs the role `programmer`. A token with scopes needs `library`. Takes effect once under an `Idempotency-Key`. Changes the revision that `If-Match` names.
         */
        put: operations["put_families_name"];
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/parts": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * parts: families with values
         * @description Needs the role `viewer`. The next page is `after` the `next` of this one.
         */
        get: operations["get_parts"];
        put?: never;
        /**
         * add a part
         * @description Needs the role `programmer`. A token with scopes needs `library`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_parts"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/parts/{number}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * one part
         * @description Needs the role `viewer`.
         */
        get: operations["get_parts_number"];
        /**
         * a new revision of a part's values
         * @description Needs the role `programmer`. A token with scopes needs `library`. Takes effect once under an `Idempotency-Key`. Changes the revision that `If-Match` names.
         */
        put: operations["put_parts_number"];
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/programs": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * programs
         * @description Needs the role `viewer`. The next page is `after` the `next` of this one.
         */
        get: operations["get_programs"];
        put?: never;
        /**
         * add a program by its text
         * @description Needs the role `programmer`. A token with scopes needs `library`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_programs"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/programs/{id}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * one program
         * @description Needs the role `viewer`.
         */
        get: operations["get_programs_id"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        /**
         * give a program tags and a folder
         * @description Needs the role `programmer`. A token with scopes needs `library`. Takes effect once under an `Idempotency-Key`.
         */
        patch: operations["patch_programs_id"];
        trace?: never;
    };
    "/api/v1/programs/{id}/text": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * the text of a revision
         * @description Needs the role `viewer`.
         */
        get: operations["get_programs_id_text"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/programs/{id}/lines": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * some lines of a revision, each with the family's line and values that it was rendered from
         * @description Needs the role `viewer`.
         */
        get: operations["get_programs_id_lines"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/programs/{id}/revisions": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * revisions, newest first
         * @description Needs the role `viewer`. The next page is `after` the `next` of this one.
         */
        get: operations["get_programs_id_revisions"];
        put?: never;
        /**
         * a new revision of the text
         * @description Needs the role `programmer`. A token with scopes needs `library`. Takes effect once under an `Idempotency-Key`. Changes the revision that `If-Match` names.
         */
        post: operations["post_programs_id_revisions"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/programs/{id}/compare": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * compare a revision with another one, or with another program's: text, meaning, motions
         * @description Needs the role `viewer`.
         */
        get: operations["get_programs_id_compare"];
        put?: never;
        /**
         * compare a text that is being written with a revision: text, meaning, motions; it is not stored
         * @description Needs the role `programmer`. A token with scopes needs `checks`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_programs_id_compare"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/programs/{id}/path": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * the toolpath of a revision, as points, and what is not known of it
         * @description Needs the role `viewer`.
         */
        get: operations["get_programs_id_path"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/programs/{id}/picture": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * a small drawing of a revision's toolpath, for a list
         * @description Needs the role `viewer`.
         */
        get: operations["get_programs_id_picture"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/programs/{id}/stock": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * the stock of a revision from the first cut to the last, as columns of numbers that its head describes
         * @description Needs the role `viewer`.
         */
        get: operations["get_programs_id_stock"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/programs/{id}/archive": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * put a program aside, with a reason: it takes no revision and no release
         * @description Needs the role `programmer`. A token with scopes needs `library`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_programs_id_archive"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/programs/{id}/fetch-back": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * use an archived program again, with a reason
         * @description Needs the role `programmer`. A token with scopes needs `library`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_programs_id_fetch_back"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/programs/{id}/delete": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * delete an archived program for good, with a reason; what releases, jobs and the ledger name of it stays
         * @description Needs the role `approver`. A token with scopes needs `library`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_programs_id_delete"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/programs/{id}/uses": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * which parts, releases, jobs, machines and other programs use a program, and which ones it calls
         * @description Needs the role `viewer`.
         */
        get: operations["get_programs_id_uses"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/attachments": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * files that are attached: setup sheets, drawings, pictures; newest first, without those that were removed
         * @description Needs the role `viewer`. The next page is `after` the `next` of this one.
         */
        get: operations["get_attachments"];
        put?: never;
        /**
         * attach a file to one program, family, part or order; the body is the file, Content-Type its type
         * @description Needs the role `programmer`. A token with scopes needs `library`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_attachments"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/attachments/{id}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * one attached file, also one that was removed
         * @description Needs the role `viewer`.
         */
        get: operations["get_attachments_id"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/attachments/{id}/content": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * the file itself, to be saved; its type, where that is one of a list of harmless ones
         * @description Needs the role `viewer`.
         */
        get: operations["get_attachments_id_content"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/attachments/{id}/remove": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * remove a file, with a reason; what it was stays known
         * @description Needs the role `programmer`. A token with scopes needs `library`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_attachments_id_remove"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/search": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * programs by words: names, numbers, tags, part, machine, comments, text; best first
         * @description Needs the role `viewer`.
         */
        get: operations["get_search"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/diagnose": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * what the reader and the validator find in a text that is being written; it is neither run nor stored
         * @description Needs the role `programmer`. A token with scopes needs `checks`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_diagnose"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/imports": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * take one file into the library: a program, or the memory of a control with many; the body is the file
         * @description Needs the role `programmer`. A token with scopes needs `library`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_imports"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/split": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * the programs of a text that holds several, as controls dump their memory; they are not stored
         * @description Needs the role `programmer`. A token with scopes needs `library`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_split"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/convert": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * a text or stored program in another control's language, run on both sides where it can be; it is not stored
         * @description Needs the role `programmer`. A token with scopes needs `checks`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_convert"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/optimize": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * a text or stored program made faster for its control, with the same moves; it is not stored
         * @description Needs the role `programmer`. A token with scopes needs `checks`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_optimize"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/rewrite": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * a text that is being written with other block numbers, blanks or letters: the same program, or refused; it is not stored
         * @description Needs the role `programmer`. A token with scopes needs `checks`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_rewrite"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/path": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * the toolpath of a text that is being written; it is not stored
         * @description Needs the role `programmer`. A token with scopes needs `checks`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_path"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/stock": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * the stock of a text that is being written from the first cut to the last, as columns of numbers; it is not stored
         * @description Needs the role `programmer`. A token with scopes needs `checks`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_stock"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/statistics": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * how far and, on a machine, how long the tools of a text move; it is not stored
         * @description Needs the role `programmer`. A token with scopes needs `checks`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_statistics"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/dialects/{name}/words": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * codes, keywords, functions, cycles and system variables of a dialect, each with a few words on it
         * @description Needs the role `viewer`.
         */
        get: operations["get_dialects_name_words"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/render": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * render a part or family for a machine and store the program
         * @description Needs the role `programmer`. A token with scopes needs `checks`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_render"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/preview": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * what rendering would give, stored nowhere
         * @description Needs the role `programmer`. A token with scopes needs `checks`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_preview"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/preview/verdict": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * what a check of the program that rendering would give finds, stored nowhere
         * @description Needs the role `programmer`. A token with scopes needs `checks`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_preview_verdict"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/checks": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * verdicts, newest first
         * @description Needs the role `viewer`. The next page is `after` the `next` of this one.
         */
        get: operations["get_checks"];
        put?: never;
        /**
         * check a program for a machine and store the verdict
         * @description Needs the role `programmer`. A token with scopes needs `checks`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_checks"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/checks/{id}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * one verdict with its report
         * @description Needs the role `viewer`.
         */
        get: operations["get_checks_id"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/checks/{id}/waivers": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * waive a verdict or one point of it, with a reason; it may end by itself
         * @description Needs the role `approver`. A token with scopes needs `releases`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_checks_id_waivers"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/accuracy": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * how far a program's surface lies from the nominal, and measured points; with plot=deviation as SVG
         * @description Needs the role `programmer`. A token with scopes needs `checks`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_accuracy"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/gouge": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * a program's rapids into stock or part and cuts below the nominal; with plot=stock as SVG
         * @description Needs the role `programmer`. A token with scopes needs `checks`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_gouge"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/timing": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * how long a program takes on a machine and its line; with plot=feed or plot=buffer as SVG
         * @description Needs the role `programmer`. A token with scopes needs `checks`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_timing"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/sweep": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * for which values a family passes on a machine, and the smallest failure; with plot=region as SVG
         * @description Needs the role `programmer`. A token with scopes needs `checks`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_sweep"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/work": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * heavy work that waits or runs now, in the order in which it came
         * @description Needs the role `viewer`.
         */
        get: operations["get_work"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/work/{id}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        post?: never;
        /**
         * cancel it: only the person who asked for it, or an admin
         * @description Needs the role `programmer`. A token with scopes needs `checks`. Takes effect once under an `Idempotency-Key`.
         */
        delete: operations["delete_work_id"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/releases": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * releases, newest first
         * @description Needs the role `viewer`. The next page is `after` the `next` of this one.
         */
        get: operations["get_releases"];
        put?: never;
        /**
         * a draft that binds text, machine and delivery
         * @description Needs the role `programmer`. A token with scopes needs `releases`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_releases"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/releases/{id}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * one release
         * @description Needs the role `viewer`.
         */
        get: operations["get_releases_id"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/releases/{id}/transitions": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * move a release on; a programmer hands it in for review, all else is an approver's
         * @description Needs the role `programmer`. A token with scopes needs `releases`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_releases_id_transitions"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/releases/{id}/sign-off": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * an operator signs off what the transfers of a proving have shown; an approver approves it after that
         * @description Needs the role `operator`. A token with scopes needs `releases`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_releases_id_sign_off"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/releases/{id}/restart-preview": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * the restart of the released text at a line, and what it assumes; stored nowhere
         * @description Needs the role `operator`. A token with scopes needs `releases`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_releases_id_restart_preview"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/releases/{id}/restarts": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * a release in review of the restart that was shown; an approver releases it for one transfer
         * @description Needs the role `programmer`. A token with scopes needs `releases`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_releases_id_restarts"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/orders": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * what is to be made, newest first
         * @description Needs the role `viewer`. The next page is `after` the `next` of this one.
         */
        get: operations["get_orders"];
        put?: never;
        /**
         * add an order; the same number, operation and plan again is the same order
         * @description Needs the role `operator`. A token with scopes needs `queue`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_orders"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/orders/{id}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * one order
         * @description Needs the role `viewer`.
         */
        get: operations["get_orders_id"];
        /**
         * change the plan of an order
         * @description Needs the role `operator`. A token with scopes needs `queue`. Takes effect once under an `Idempotency-Key`. Changes the revision that `If-Match` names.
         */
        put: operations["put_orders_id"];
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/orders/{id}/move": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * hold, open, close or cancel an order; while it is not open, none of its jobs is armed
         * @description Needs the role `operator`. A token with scopes needs `queue`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_orders_id_move"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/orders/{id}/parts": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * report parts that were made
         * @description Needs the role `operator`. A token with scopes needs `queue`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_orders_id_parts"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jobs": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * transfers, newest first
         * @description Needs the role `viewer`. The next page is `after` the `next` of this one.
         */
        get: operations["get_jobs"];
        put?: never;
        /**
         * queue a released program
         * @description Needs the role `operator`. A token with scopes needs `queue`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_jobs"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jobs/{id}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * one job
         * @description Needs the role `viewer`.
         */
        get: operations["get_jobs_id"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jobs/{id}/forecast": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * how long its program takes by its verdict, line by line, and what the control's buffer holds
         * @description Needs the role `viewer`.
         */
        get: operations["get_jobs_id_forecast"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jobs/{id}/arm": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * a person arms the job for its machine's line
         * @description Needs the role `operator`. A token with scopes needs `line`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_jobs_id_arm"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jobs/{id}/move": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * move a queued job before another one, or to the end
         * @description Needs the role `operator`. A token with scopes needs `queue`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_jobs_id_move"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jobs/{id}/schedule": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * when a queued job may be armed; nothing is armed by it
         * @description Needs the role `operator`. A token with scopes needs `queue`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_jobs_id_schedule"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jobs/{id}/hold": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * put a queued job on hold: it keeps its place and is not armed
         * @description Needs the role `operator`. A token with scopes needs `queue`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_jobs_id_hold"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jobs/{id}/end-hold": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * take a queued job off hold
         * @description Needs the role `operator`. A token with scopes needs `queue`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_jobs_id_end_hold"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jobs/{id}/retry": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * queue the release of a job that ended again, for the same order and with the same confirmation of its end
         * @description Needs the role `operator`. A token with scopes needs `queue`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_jobs_id_retry"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jobs/{id}/confirm-end": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * a person confirms what the end of a job asks for, before the next one of the machine is armed
         * @description Needs the role `operator`. A token with scopes needs `line`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_jobs_id_confirm_end"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jobs/{id}/stop-reasons": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * why a job stood still or broke off, as people stated it
         * @description Needs the role `viewer`.
         */
        get: operations["get_jobs_id_stop_reasons"];
        put?: never;
        /**
         * state why a job stood still or broke off; it changes nothing else
         * @description Needs the role `operator`. A token with scopes needs `line`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_jobs_id_stop_reasons"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jobs/{id}/stop": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * stop at a block end
         * @description Needs the role `operator`. A token with scopes needs `line`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_jobs_id_stop"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jobs/{id}/cancel": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * end at a block end
         * @description Needs the role `operator`. A token with scopes needs `line`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_jobs_id_cancel"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jobs/{id}/resume": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * go on; as if DC1 had come, with a reason
         * @description Needs the role `operator`. A token with scopes needs `line`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_jobs_id_resume"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/history/sums": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * sums of the transfers that ended in a time: durations, holds, line use, forecasts; as CSV where the request accepts that
         * @description Needs the role `viewer`.
         */
        get: operations["get_history_sums"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/stop-reasons": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * which reasons of a stop there are, and how often each was stated in a time
         * @description Needs the role `viewer`.
         */
        get: operations["get_stop_reasons"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/alarms": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * alarms, newest first; with state=open those that ask for a person
         * @description Needs the role `viewer`. The next page is `after` the `next` of this one.
         */
        get: operations["get_alarms"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/alarms/{id}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * one alarm
         * @description Needs the role `viewer`.
         */
        get: operations["get_alarms_id"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/alarms/{id}/acknowledge": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * a person acknowledges it
         * @description Needs the role `operator`. A token with scopes needs `line`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_alarms_id_acknowledge"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/alarms/{id}/shelve": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * it asks for no person for some minutes, with a reason; not a critical one
         * @description Needs the role `operator`. A token with scopes needs `line`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_alarms_id_shelve"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/alarms/{id}/unshelve": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * it asks again
         * @description Needs the role `operator`. A token with scopes needs `line`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_alarms_id_unshelve"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/event-types": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * events that are sent to other systems by webhooks and MQTT
         * @description Needs the role `viewer`.
         */
        get: operations["get_event_types"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/webhooks": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * who receives events by HTTP, newest first
         * @description Needs the role `admin`. The next page is `after` the `next` of this one.
         */
        get: operations["get_webhooks"];
        put?: never;
        /**
         * post events to a URL from now on (Standard Webhooks 1.0); its secret is shown here and never again
         * @description Needs the role `admin`. A token with scopes needs `setup`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_webhooks"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/webhooks/{id}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * one webhook, without its secret
         * @description Needs the role `admin`.
         */
        get: operations["get_webhooks_id"];
        put?: never;
        post?: never;
        /**
         * remove a webhook with its deliveries
         * @description Needs the role `admin`. A token with scopes needs `setup`. Takes effect once under an `Idempotency-Key`.
         */
        delete: operations["delete_webhooks_id"];
        options?: never;
        head?: never;
        /**
         * change the given members of a webhook
         * @description Needs the role `admin`. A token with scopes needs `setup`. Takes effect once under an `Idempotency-Key`.
         */
        patch: operations["patch_webhooks_id"];
        trace?: never;
    };
    "/api/v1/webhooks/{id}/rotate": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * a new secret, shown once; the previous one also signs for some hours
         * @description Needs the role `admin`. A token with scopes needs `setup`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_webhooks_id_rotate"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/webhooks/{id}/ping": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * send it an event webhook.ping, to try it
         * @description Needs the role `admin`. A token with scopes needs `setup`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_webhooks_id_ping"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/webhooks/{id}/deliveries": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * events that are being delivered to it, newest first
         * @description Needs the role `admin`. The next page is `after` the `next` of this one.
         */
        get: operations["get_webhooks_id_deliveries"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/webhooks/{id}/deliveries/{delivery}/replay": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * send one again, with the same webhook-id
         * @description Needs the role `admin`. A token with scopes needs `setup`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_webhooks_id_deliveries_delivery_replay"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/webhooks/{id}/replay": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * send all dead ones again whose event is not older
         * @description Needs the role `admin`. A token with scopes needs `setup`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_webhooks_id_replay"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/receipts": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * what controls punched, newest first
         * @description Needs the role `viewer`. The next page is `after` the `next` of this one.
         */
        get: operations["get_receipts"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/receipts/{id}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * one receipt, compared with the stored program of its name
         * @description Needs the role `viewer`.
         */
        get: operations["get_receipts_id"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/receipts/{id}/text": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * its text; of one in quarantine the bytes, or with form=read their text
         * @description Needs the role `viewer`.
         */
        get: operations["get_receipts_id_text"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/receipts/{id}/explain": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * which values of the part make its family give the received text; they are rendered and compared
         * @description Needs the role `programmer`. A token with scopes needs `library`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_receipts_id_explain"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/receipts/{id}/accept": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * make it a program's revision; one in quarantine by an approver, with a reason
         * @description Needs the role `programmer`. A token with scopes needs `library`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_receipts_id_accept"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/receipts/{id}/discard": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * it is not wanted, with a reason
         * @description Needs the role `approver`. A token with scopes needs `library`. Takes effect once under an `Idempotency-Key`.
         */
        post: operations["post_receipts_id_discard"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/requests": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * what operators asked for, newest first
         * @description Needs the role `viewer`. The next page is `after` the `next` of this one.
         */
        get: operations["get_requests"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jobs/{id}/ledger": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * what is known of a transfer
         * @description Needs the role `viewer`.
         */
        get: operations["get_jobs_id_ledger"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
}
export interface webhooks {
    "program.added": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * a program is new
         * @description Posted to webhooks that want this type, until it is taken.
         */
        post: operations["webhook_program_added"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "program.revised": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * a program has a new revision of its text
         * @description Posted to webhooks that want this type, until it is taken.
         */
        post: operations["webhook_program_revised"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "program.archived": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * a program is out of use
         * @description Posted to webhooks that want this type, until it is taken.
         */
        post: operations["webhook_program_archived"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "program.fetched_back": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * an archived program is in use again
         * @description Posted to webhooks that want this type, until it is taken.
         */
        post: operations["webhook_program_fetched_back"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "program.deleted": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * an archived program was deleted for good
         * @description Posted to webhooks that want this type, until it is taken.
         */
        post: operations["webhook_program_deleted"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "order.added": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * an order is new
         * @description Posted to webhooks that want this type, until it is taken.
         */
        post: operations["webhook_order_added"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "order.changed": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * the plan of an order changed
         * @description Posted to webhooks that want this type, until it is taken.
         */
        post: operations["webhook_order_changed"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "order.parts": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * parts were reported to an order
         * @description Posted to webhooks that want this type, until it is taken.
         */
        post: operations["webhook_order_parts"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "order.open": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * jobs of an order may be queued and armed again
         * @description Posted to webhooks that want this type, until it is taken.
         */
        post: operations["webhook_order_open"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "order.held": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * no job of an order may be queued or armed
         * @description Posted to webhooks that want this type, until it is taken.
         */
        post: operations["webhook_order_held"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "order.done": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * a person or the MES closed an order
         * @description Posted to webhooks that want this type, until it is taken.
         */
        post: operations["webhook_order_done"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "order.cancelled": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * an order is no longer wanted
         * @description Posted to webhooks that want this type, until it is taken.
         */
        post: operations["webhook_order_cancelled"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "release.draft": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * a release was made
         * @description Posted to webhooks that want this type, until it is taken.
         */
        post: operations["webhook_release_draft"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "release.in_review": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * a release waits for its review
         * @description Posted to webhooks that want this type, until it is taken.
         */
        post: operations["webhook_release_in_review"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "release.proving": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * a release may be transferred some times, to prove it at the machine
         * @description Posted to webhooks that want this type, until it is taken.
         */
        post: operations["webhook_release_proving"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "release.signed_off": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * an operator signed off what the proving has shown
         * @description Posted to webhooks that want this type, until it is taken.
         */
        post: operations["webhook_release_signed_off"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "release.approved": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * an approver approved a release for the machine
         * @description Posted to webhooks that want this type, until it is taken.
         */
        post: operations["webhook_release_approved"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "release.obsolete": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * a release may no longer be transferred
         * @description Posted to webhooks that want this type, until it is taken.
         */
        post: operations["webhook_release_obsolete"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "job.queued": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * a job was queued, or it is no longer armed and back in the queue
         * @description Posted to webhooks that want this type, until it is taken.
         */
        post: operations["webhook_job_queued"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "job.armed": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * a person armed the job: it waits for the control's start
         * @description Posted to webhooks that want this type, until it is taken.
         */
        post: operations["webhook_job_armed"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "job.feeding": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * the control asked and the transfer began
         * @description Posted to webhooks that want this type, until it is taken.
         */
        post: operations["webhook_job_feeding"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "job.done": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * all was sent and the end was seen; it does not say that a part was made
         * @description Posted to webhooks that want this type, until it is taken.
         */
        post: operations["webhook_job_done"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "job.failed": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * the transfer broke off
         * @description Posted to webhooks that want this type, until it is taken.
         */
        post: operations["webhook_job_failed"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "job.cancelled": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * a person ended the job
         * @description Posted to webhooks that want this type, until it is taken.
         */
        post: operations["webhook_job_cancelled"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "job.interrupted": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * the server ended while the job had its line
         * @description Posted to webhooks that want this type, until it is taken.
         */
        post: operations["webhook_job_interrupted"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "job.scheduled": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * a person changed the time before which a queued job is not armed
         * @description Posted to webhooks that want this type, until it is taken.
         */
        post: operations["webhook_job_scheduled"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "job.on_hold": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * a person put a queued job on hold: it is not armed
         * @description Posted to webhooks that want this type, until it is taken.
         */
        post: operations["webhook_job_on_hold"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "job.off_hold": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * a queued job is no longer on hold
         * @description Posted to webhooks that want this type, until it is taken.
         */
        post: operations["webhook_job_off_hold"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "job.end_confirmed": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * a person looked at the end of a transfer: the machine's next job may be armed
         * @description Posted to webhooks that want this type, until it is taken.
         */
        post: operations["webhook_job_end_confirmed"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "job.stop_reason": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * a person stated why a transfer stood still or broke off
         * @description Posted to webhooks that want this type, until it is taken.
         */
        post: operations["webhook_job_stop_reason"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "line.disconnected": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * the link to the control is not up
         * @description Posted to webhooks that want this type, until it is taken.
         */
        post: operations["webhook_line_disconnected"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "line.idle": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * the link is up and nothing is armed
         * @description Posted to webhooks that want this type, until it is taken.
         */
        post: operations["webhook_line_idle"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "line.armed": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * a job waits for the control's start
         * @description Posted to webhooks that want this type, until it is taken.
         */
        post: operations["webhook_line_armed"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "line.feeding": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * blocks go out
         * @description Posted to webhooks that want this type, until it is taken.
         */
        post: operations["webhook_line_feeding"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "line.held": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * the control, or a person, holds the feed
         * @description Posted to webhooks that want this type, until it is taken.
         */
        post: operations["webhook_line_held"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "line.draining": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * all was handed over, the end is not seen
         * @description Posted to webhooks that want this type, until it is taken.
         */
        post: operations["webhook_line_draining"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "line.torn": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * a block broke off: a person must confirm that the control was reset
         * @description Posted to webhooks that want this type, until it is taken.
         */
        post: operations["webhook_line_torn"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "line.receiving": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * the control punches
         * @description Posted to webhooks that want this type, until it is taken.
         */
        post: operations["webhook_line_receiving"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "line.answering": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * an answer to the operator waits for the control, or is sent
         * @description Posted to webhooks that want this type, until it is taken.
         */
        post: operations["webhook_line_answering"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "alarm.raised": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * an alarm is new, or is on again
         * @description Posted to webhooks that want this type, until it is taken.
         */
        post: operations["webhook_alarm_raised"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "alarm.cleared": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * the condition of an alarm is over
         * @description Posted to webhooks that want this type, until it is taken.
         */
        post: operations["webhook_alarm_cleared"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "alarm.acknowledged": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * a person knows of an alarm
         * @description Posted to webhooks that want this type, until it is taken.
         */
        post: operations["webhook_alarm_acknowledged"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "alarm.shelved": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * a person shelved an alarm
         * @description Posted to webhooks that want this type, until it is taken.
         */
        post: operations["webhook_alarm_shelved"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "alarm.unshelved": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * an alarm asks for a person again
         * @description Posted to webhooks that want this type, until it is taken.
         */
        post: operations["webhook_alarm_unshelved"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "receipt.stored": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * a control punched a program
         * @description Posted to webhooks that want this type, until it is taken.
         */
        post: operations["webhook_receipt_stored"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "receipt.quarantined": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * a control punched something that is broken
         * @description Posted to webhooks that want this type, until it is taken.
         */
        post: operations["webhook_receipt_quarantined"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "receipt.accepted": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * a receipt became a program's revision
         * @description Posted to webhooks that want this type, until it is taken.
         */
        post: operations["webhook_receipt_accepted"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "receipt.discarded": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * a receipt is not wanted
         * @description Posted to webhooks that want this type, until it is taken.
         */
        post: operations["webhook_receipt_discarded"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "webhook.ping": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * a person tries a webhook; it alone gets this
         * @description Posted to webhooks that want this type, until it is taken.
         */
        post: operations["webhook_webhook_ping"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
}
export interface components {
    schemas: {
        /**
         * @description why a request was not answered (RFC 9457)
         * @example {
         *       "type": "about:blank",
         *       "title": "no verdict",
         *       "status": 409,
         *       "code": "no_verdict",
         *       "detail": "the text was never checked for this machine and delivery",
         *       "said": {
         *         "id": "store_no_verdict",
         *         "values": {}
         *       }
         *     }
         */
        Problem: {
            /** @description about:blank */
            type: string;
            /** @description the kind of problem, the same for each of its kind */
            title: string;
            /** @description of HTTP */
            status: number;
            /**
             * @description what it is, for programs; a code keeps its name, status and meaning
             * @enum {string}
             */
            code: "malformed" | "not_signed_in" | "wrong_secret" | "not_allowed" | "role_missing" | "scope_missing" | "not_found" | "method_not_allowed" | "refused" | "exists" | "in_progress" | "other_user" | "wrong_state" | "no_verdict" | "verdict_not_passed" | "verdict_stale" | "not_released" | "no_machine_of_group" | "transfers_used_up" | "sign_off_missing" | "not_proved" | "not_signed_off" | "four_eyes" | "machine_busy" | "machine_torn" | "too_early" | "on_hold" | "end_not_confirmed" | "hook_refused" | "hook_unanswered" | "sign_in_not_begun" | "provider_refused" | "id_token_refused" | "name_taken" | "account_waits" | "no_role" | "line_down" | "append_only" | "stale_revision" | "too_large" | "no_json" | "invalid" | "key_reused" | "revision_missing" | "too_many" | "header_too_large" | "internal" | "unavailable" | "provider_unanswered" | "overloaded" | "disk_full" | "no_room" | "over_quota";
            /** @description one sentence for a person */
            detail: string;
            said?: components["schemas"]["Said"] | null;
            /** @description each place that is wrong */
            errors?: {
                /** @description JSON pointer into the request's body */
                pointer?: string;
                /** @description of a text, from 1 */
                line?: number;
                /** @description of that line, from 1, in bytes */
                column?: number;
                /** @description what is wrong there */
                text: string;
            }[];
        };
        /** @description a sentence as an id with values, for other languages; null where it has none */
        Said: {
            /**
             * @description of the sentence, the same in every version
             * @enum {string}
             */
            id: "control_asked_again" | "nothing_leaves" | "link_down" | "link_down_plain" | "ledger_not_written" | "machine_alarm_at" | "machine_alarm" | "device_text" | "reception_lost" | "program_lost" | "in_quarantine" | "request_not_answered" | "answer_hides" | "ring_not_recorded" | "request_expired" | "answer_cannot" | "answer_not_sent" | "read_back_of" | "flooded" | "more_alarms" | "no_maintenance" | "maintenance_runs" | "no_backup_of_database" | "backup_no_room" | "no_such_backup" | "store_has_faults" | "store_cannot_be_read" | "quarantine_not_compared" | "no_program_of_name" | "not_rendered" | "too_long_for_values" | "block_torn_here" | "line_tested" | "line_no_characters" | "line_confirm_first" | "line_control_there" | "line_busy_settings" | "line_still_used" | "restart_is_sent_once" | "line_in_use" | "no_line_because" | "line_elsewhere" | "only_server" | "no_line" | "too_fast" | "control_sends" | "torn_reset_first" | "maybe_torn" | "other_session" | "only_receives" | "job_on_line" | "no_torn" | "server_ends" | "reached_torn_because_lines" | "reached_torn_lines" | "reached_because_lines" | "reached_lines" | "reached_torn_because" | "reached_torn" | "reached_because" | "reached" | "nothing_sent_because" | "nothing_sent" | "disarmed" | "answer_torn" | "answer_torn_plain" | "block_torn_confirm" | "read_back_result" | "no_effect" | "no_text" | "asked_again_restart" | "cannot_arm" | "stops_without_store" | "folder_needs_memory" | "changed_after_verdict" | "job_not_on_line" | "arming_time" | "resume_reason" | "job_waits" | "nothing_waits" | "job_holds_profile" | "withdrawn" | "early_by_approver" | "none_of_group" | "hook_refuses" | "hook_silent" | "admin_loads" | "disk_full_ends" | "alarm_critical" | "reason_needed" | "quarantine_reason" | "receipt_unreadable" | "approver_accepts" | "approver_needed" | "text_empty" | "text_unreadable" | "keeps_name" | "other_dialect" | "needs_role" | "sign_in" | "token_scope" | "page_shows_other" | "wrong_secret" | "token_not_valid" | "sign_in_other" | "sign_in_late" | "sign_in_used" | "no_provider" | "provider_silent" | "provider_unusable" | "provider_refuses" | "id_token_refused" | "provider_no_name" | "provider_name_taken" | "provider_no_group" | "account_not_enabled" | "account_locked" | "too_many_wrong" | "present_password" | "secret_empty" | "own_admin" | "being_answered" | "request_failed_inside" | "body_too_long" | "too_many_large" | "too_many_waiting" | "too_many_sign_ins" | "watch_already" | "search_not_there" | "sweep_runs" | "cancel_other" | "import_hidden" | "import_empty" | "import_no_program" | "import_too_long" | "import_archived" | "import_in_use" | "import_brought" | "import_several" | "store_not_found" | "store_exists" | "store_stale" | "store_reference" | "store_value" | "store_transition" | "store_no_verdict" | "store_not_passed" | "store_verdict_stale" | "store_not_released" | "store_used_up" | "store_sign_off" | "store_not_proved" | "store_not_signed_off" | "store_four_eyes" | "store_machine_busy" | "store_not_leased" | "store_machine_torn" | "store_too_early" | "store_on_hold" | "store_end_not_confirmed" | "store_key_reused" | "store_append_only" | "store_busy" | "store_in_use" | "store_disk_full" | "store_unreachable" | "store_no_answer" | "store_io" | "store_corrupt" | "store_internal" | "line_is";
            /** @description by name; `detail`: what is added in brackets */
            values: {
                [key: string]: {
                    /** @description as it stands in the sentence */
                    text: string;
                    said: components["schemas"]["Said"] | null;
                };
            };
        };
        /**
         * @description the server is alive
         * @example {
         *       "status": "ok",
         *       "version": "1"
         *     }
         */
        Health: {
            /**
             * @description of the server
             * @enum {string}
             */
            status: "ok";
            /** @description of the server */
            version: string;
        };
        /** @description the API's description (OpenAPI 3.1) */
        OpenApi: {
            /** @description its version */
            openapi: string;
            /** @description as OpenAPI has it */
            info: unknown;
            /** @description as OpenAPI has it */
            servers: unknown;
            /** @description groups of routes */
            tags: unknown;
            /** @description as OpenAPI has it */
            security: unknown;
            /** @description by path */
            paths: unknown;
            /** @description what is posted to others, by type */
            webhooks: unknown;
            /** @description schemas by name */
            components: unknown;
        };
        /**
         * @description what a person should know about a machine; it is open while it is not over or not acknowledged
         * @example {
         *       "id": 1,
         *       "machine": "lathe",
         *       "kind": "torn_block",
         *       "text": "link_lost: between wire byte 0 and 29 of 3831 may have reached the control (line 1 to 5); a block is torn: reset the control and confirm it; Connection reset by peer",
         *       "said": {
         *         "id": "reached_torn_because_lines",
         *         "values": {
         *           "cause": {
         *             "text": "link_lost",
         *             "said": null
         *           },
         *           "from": {
         *             "text": "0",
         *             "said": null
         *           },
         *           "to": {
         *             "text": "29",
         *             "said": null
         *           },
         *           "total": {
         *             "text": "3831",
         *             "said": null
         *           },
         *           "first": {
         *             "text": "1",
         *             "said": null
         *           },
         *           "last": {
         *             "text": "5",
         *             "said": null
         *           },
         *           "why": {
         *             "text": "Connection reset by peer",
         *             "said": null
         *           }
         *         }
         *       },
         *       "count": 1,
         *       "severity": "critical",
         *       "raised_at_ms": 1795879628552,
         *       "last_at_ms": 1795879628552,
         *       "cleared_at_ms": null,
         *       "acknowledged_by": "the operator",
         *       "acknowledged_at_ms": 1795879629845,
         *       "shelved_by": null,
         *       "shelved_until_ms": null,
         *       "shelf_reason": null,
         *       "job": 1
         *     }
         */
        Alarm: {
            /** @description of the alarm */
            id: number;
            /** @description its name */
            machine: string;
            /**
             * @description what it is about
             * @enum {string}
             */
            kind: "torn_block" | "reset_suspected" | "line_refused" | "ledger_failed" | "link_lost" | "line_flooded" | "link_note" | "machine_alarm" | "person_called" | "reception_lost" | "quarantined" | "device_text" | "request_failed" | "request_expired" | "read_back_differs" | "read_back_expired";
            /**
             * @description by its kind
             * @enum {string}
             */
            severity: "critical" | "warning" | "notice";
            /** @description one sentence */
            text: string;
            said: components["schemas"]["Said"] | null;
            /** @description how often it was raised while it was open */
            count: number;
            /** @description the first time; milliseconds since 1970, UTC */
            raised_at_ms: number;
            /** @description the last time; milliseconds since 1970, UTC */
            last_at_ms: number;
            /** @description when its condition was over; null: it lasts; milliseconds since 1970, UTC */
            cleared_at_ms: number | null;
            /** @description who acknowledged it */
            acknowledged_by: string | null;
            /** @description since when; milliseconds since 1970, UTC */
            acknowledged_at_ms: number | null;
            /** @description who shelved it */
            shelved_by: string | null;
            /** @description it asks for no person until then; milliseconds since 1970, UTC */
            shelved_until_ms: number | null;
            /** @description why it was shelved */
            shelf_reason: string | null;
            /** @description that it is about */
            job: number | null;
        };
        /**
         * @description what a person should know about a machine; it is open while it is not over or not acknowledged
         * @example {
         *       "id": 1,
         *       "machine": "lathe",
         *       "kind": "torn_block",
         *       "text": "link_lost: between wire byte 0 and 29 of 3831 may have reached the control (line 1 to 5); a block is torn: reset the control and confirm it; Connection reset by peer",
         *       "said": {
         *         "id": "reached_torn_because_lines",
         *         "values": {
         *           "cause": {
         *             "text": "link_lost",
         *             "said": null
         *           },
         *           "from": {
         *             "text": "0",
         *             "said": null
         *           },
         *           "to": {
         *             "text": "29",
         *             "said": null
         *           },
         *           "total": {
         *             "text": "3831",
         *             "said": null
         *           },
         *           "first": {
         *             "text": "1",
         *             "said": null
         *           },
         *           "last": {
         *             "text": "5",
         *             "said": null
         *           },
         *           "why": {
         *             "text": "Connection reset by peer",
         *             "said": null
         *           }
         *         }
         *       },
         *       "count": 1,
         *       "severity": "critical",
         *       "raised_at_ms": 1795879628552,
         *       "last_at_ms": 1795879628552,
         *       "cleared_at_ms": null,
         *       "acknowledged_by": null,
         *       "acknowledged_at_ms": null,
         *       "shelved_by": null,
         *       "shelved_until_ms": null,
         *       "shelf_reason": null,
         *       "job": 1
         *     }
         */
        EventAlarm: {
            /** @description of the alarm */
            id: number;
            /** @description its name */
            machine: string;
            /**
             * @description what it is about
             * @enum {string}
             */
            kind: "torn_block" | "reset_suspected" | "line_refused" | "ledger_failed" | "link_lost" | "line_flooded" | "link_note" | "machine_alarm" | "person_called" | "reception_lost" | "quarantined" | "device_text" | "request_failed" | "request_expired" | "read_back_differs" | "read_back_expired";
            /**
             * @description by its kind
             * @enum {string}
             */
            severity: "critical" | "warning" | "notice";
            /** @description one sentence */
            text: string;
            said: components["schemas"]["Said"] | null;
            /** @description how often it was raised while it was open */
            count: number;
            /** @description the first time; milliseconds since 1970, UTC */
            raised_at_ms: number;
            /** @description the last time; milliseconds since 1970, UTC */
            last_at_ms: number;
            /** @description when its condition was over; null: it lasts; milliseconds since 1970, UTC */
            cleared_at_ms: number | null;
            /** @description who acknowledged it */
            acknowledged_by: string | null;
            /** @description since when; milliseconds since 1970, UTC */
            acknowledged_at_ms: number | null;
            /** @description who shelved it */
            shelved_by: string | null;
            /** @description it asks for no person until then; milliseconds since 1970, UTC */
            shelved_until_ms: number | null;
            /** @description why it was shelved */
            shelf_reason: string | null;
            /** @description that it is about */
            job: number | null;
        };
        /**
         * @description a control has punched, or its operator has asked for something
         * @example {
         *       "machine": "lathe",
         *       "text": "received O0700 (14 bytes), receipt 1"
         *     }
         */
        EventReceipt: {
            /** @description its name */
            machine: string;
            /** @description one sentence */
            text: string;
        };
        /**
         * @description events were lost, or the server is a new one: all that is shown has to be requested again
         * @example {}
         */
        EventReset: Record<string, never>;
        /**
         * @description a text as a whole
         * @example {
         *       "text": "# Finishing of a rolling-mill roll with a hyperbolic barrel, from the large end over the waist to the other end.\n# z is 0 in the middle of the roll. x = 2*half_axis_x/cos(t), z = half_axis_z*tan(t) is the hyperbola by its angle t.\nfamily hyperbolic-roll \"Hyperbolic rolling-mill roll\"\nmachine lathe, "
         *     }
         */
        NewText: {
            /** @description the whole text */
            text: string;
        };
        /**
         * @description a program by its text
         * @example {
         *       "name": "O0042",
         *       "dialect": "fanuc",
         *       "text": "%\nO0042\nG0X80.Z2.\nM30\n%\n"
         *     }
         */
        NewProgram: {
            /** @description under which the control calls it */
            name: string;
            /** @description of the control: fanuc, haas, mazak, mitsubishi-m80 or sinumerik-840d */
            dialect: string;
            /** @description the whole text */
            text: string;
        };
        /**
         * @description how a program is filed; what is not given stays
         * @example {
         *       "tags": [
         *         "pump"
         *       ],
         *       "folder": "acme"
         *     }
         */
        ProgramLabels: {
            /** @description words that the program is found by; all of them, an empty list takes them away */
            tags?: string[] | null;
            /** @description names with slashes between: "customer/pumps"; empty: in none */
            folder?: string | null;
        };
        /**
         * @description a part: a family with values
         * @example {
         *       "number": "HUB-12",
         *       "family": "hub",
         *       "values": {
         *         "bore": "42 mm",
         *         "length": "60 mm"
         *       }
         *     }
         */
        NewPart: {
            /** @description of the part, its name */
            number: string;
            /** @description name of a part family */
            family: string;
            /** @description by parameter, with their units ("120 mm"); what is not given has the family's default */
            values?: {
                [key: string]: string | number;
            } | null;
        };
        /**
         * @description all values of a part's new revision
         * @example {
         *       "values": {
         *         "angle_step": "1 deg"
         *       }
         *     }
         */
        PartChange: {
            /** @description all of the part's, with their units; what is not given has the family's default */
            values?: {
                [key: string]: string | number;
            } | null;
        };
        /**
         * @description what is rendered, and for which machine
         * @example {
         *       "part": "HUB-12",
         *       "machine": "lathe-1",
         *       "delivery": "drip"
         *     }
         */
        RenderOrder: {
            /** @description number of the part; or family and values */
            part?: string | null;
            /** @description name of a part family */
            family?: string | null;
            /** @description by parameter, with their units ("120 mm"); what is not given has the family's default */
            values?: {
                [key: string]: string | number;
            } | null;
            /** @description name of the machine */
            machine: string;
            /** @description of the program; not given: after part or family */
            name?: string | null;
            /**
             * @description how the text is sent to the control; not given: drip
             * @enum {string|null}
             */
            delivery?: "drip" | "memory" | null;
            /**
             * @description macro: the control computes, explicit: dripfeed computes; not given: auto
             * @enum {string|null}
             */
            mode?: "macro" | "explicit" | "auto" | null;
            /** @description whether a macro is rewritten so that the control computes it faster; not given: false */
            optimize?: boolean | null;
        };
        /**
         * @description what is checked, and for which machine
         * @example {
         *       "program": 77,
         *       "machine": "lathe-1",
         *       "delivery": "drip"
         *     }
         */
        CheckOrder: {
            /** @description id of the program */
            program: number;
            /** @description of the program's text; not given: the newest */
            revision?: number | null;
            /** @description name of the machine */
            machine: string;
            /**
             * @description how the text is sent to the control; not given: drip
             * @enum {string|null}
             */
            delivery?: "drip" | "memory" | null;
            /** @description what the program should make; not given: of a rendered program its family */
            nominal?: {
                /** @description name of the part family whose nominal counts */
                family: string;
                /** @description by parameter, with their units ("120 mm"); what is not given has the family's default */
                values?: {
                    [key: string]: string | number;
                } | null;
            } | null;
            /** @description lines that cut the nominal, as "12-60,70-71"; not given: all cuts */
            profile?: string | null;
        };
        /**
         * @description a text and the control that it is translated for
         * @example {
         *       "text": "G21\nT1 M6\nG0 G54 G17 G90 X0 Y0\nS800 M3\nG0 G43 Z5. H1\nG1 Z-2. F100\nX40. F300\nG0 Z100.\nM30\n",
         *       "dialect": "fanuc",
         *       "to": "sinumerik-840d"
         *     }
         */
        ConvertOrder: {
            /** @description the whole text; or program */
            text?: string | null;
            /** @description id of a stored program; or text */
            program?: number | null;
            /** @description of the program's text; not given: the newest */
            revision?: number | null;
            /** @description of the text; not given: the stored program's, the machine's, or the one that the text looks like */
            dialect?: string | null;
            /** @description whose control the text is for; not given: the control that the text looks like */
            machine?: string | null;
            /** @description dialect to translate to; or to_machine */
            to?: string | null;
            /** @description whose control it is translated for; or to */
            to_machine?: string | null;
            /**
             * @description macro keeps variables and loops, explicit computes them; not given: macro
             * @enum {string|null}
             */
            mode?: "macro" | "explicit" | null;
        };
        /**
         * @description a text, and how it is made faster for its control
         * @example {
         *       "text": "#101=3.\n#102=0\nG21 G90 G94 G17\nG0 X0\nWHILE[#102 LT 5] DO1\n#103=SIN[#101]*COS[#101]\nG1 X[#103+#102] F100\n#102=#102+1\nEND1\nM30\n",
         *       "dialect": "fanuc",
         *       "own": [
         *         "#101-#103"
         *       ],
         *       "without": [
         *         "invariants",
         *         "loops"
         *       ]
         *     }
         */
        OptimizeOrder: {
            /** @description the whole text; or program */
            text?: string | null;
            /** @description id of a stored program; or text */
            program?: number | null;
            /** @description of the program's text; not given: the newest */
            revision?: number | null;
            /** @description of the text; not given: the stored program's, the machine's, or the one that the text looks like */
            dialect?: string | null;
            /** @description whose control and cost model count; not given: the control that the text looks like, with its usual costs */
            machine?: string | null;
            /** @description rules that are off unless they are named here */
            with?: string[] | null;
            /** @description rules that are not applied */
            without?: string[] | null;
            /** @description variables that no other program reads: "R0-R99", "#100-#149" */
            own?: string[] | null;
            /** @description variables that the program may begin to use: "R100-R199" */
            free?: string[] | null;
            /** @description how far the path may be changed by the rules table, lines and arcs; not given: not at all */
            tolerance_mm?: number | null;
        };
        /**
         * @description a text that is being written; it is not stored
         * @example {
         *       "text": "%\nO0100 (PUMP)\nG21 G17 G90 G94 G54\nT5 M6\nN10 G0 X0. Y0.\nM98 P200\nN20 G1 X10. F100.\nGOTO20\nM30\n%\n",
         *       "machine": "lathe",
         *       "delivery": "drip"
         *     }
         */
        DiagnoseOrder: {
            /** @description the whole text */
            text?: string | null;
            /** @description in which the text is read; not given: the machine's, or the one that the text looks like */
            dialect?: string | null;
            /** @description whose control counts; not given: the one that the text looks like */
            machine?: string | null;
            /**
             * @description how the text would go to the control; not given: memory
             * @enum {string|null}
             */
            delivery?: "drip" | "memory" | null;
        };
        /**
         * @description a text that is being written, and what it should make
         * @example {
         *       "text": "G17 G90\nM30",
         *       "dialect": "fanuc",
         *       "stock": "box 0 1 0 1 0 1"
         *     }
         */
        PathOrder: {
            /** @description the whole text */
            text?: string | null;
            /** @description of a text that is not stored; not given: the machine's, or the one that the text looks like */
            dialect?: string | null;
            /** @description whose control and axes count; not given: the control that the text looks like, and no times */
            machine?: string | null;
            /**
             * @description how the text would go to the control; not given: memory
             * @enum {string|null}
             */
            delivery?: "drip" | "memory" | null;
            /** @description the family that the text is of, for deviations and stock; not given: neither is known */
            nominal?: {
                /** @description name of the part family whose nominal counts */
                family: string;
                /** @description by parameter, with their units ("120 mm"); what is not given has the family's default */
                values?: {
                    [key: string]: string | number;
                } | null;
            } | null;
            /** @description the blank as "box X0 X1 Y0 Y1 Z0 Z1" or "cylinder DIAMETER Z0 Z1", in mm; not given: the nominal's */
            stock?: string | null;
        };
        /**
         * @description a text that is being written, and how it is rewritten
         * @example {
         *       "text": "%\nO0100 (PUMP)\nG21 G17 G90 G94 G54\nT5 M6\nN10 G0 X0. Y0.\nM98 P200\nN20 G1 X10. F100.\nGOTO20\nM30\n%\n",
         *       "dialect": "fanuc",
         *       "how": "renumber",
         *       "numbering": "all",
         *       "first": 100,
         *       "step": 100
         *     }
         */
        RewriteOrder: {
            /** @description the whole text */
            text?: string | null;
            /** @description in which the text is read; not given: the machine's, or the one that the text looks like */
            dialect?: string | null;
            /** @description whose control counts; not given: the one that the text looks like */
            machine?: string | null;
            /**
             * @description how the text would go to the control; not given: memory
             * @enum {string|null}
             */
            delivery?: "drip" | "memory" | null;
            /**
             * @description what is changed of it
             * @enum {string}
             */
            how: "renumber" | "add_blanks" | "remove_blanks" | "upper_case" | "lower_case";
            /**
             * @description which blocks have a number afterwards: those that have one now, all, or only those that are named; not given: numbered
             * @enum {string|null}
             */
            numbering?: "numbered" | "all" | "none" | null;
            /** @description first number of a program; not given: 10 */
            first?: number | null;
            /** @description from one number to the next; not given: 10 */
            step?: number | null;
        };
        /**
         * @description a text that is being written, and what it is compared with
         * @example {
         *       "text": "%\nO0100\nG21 G17 G90 G94 G54\nN10 G0 X0. Y0.\nN20 G1 X10. F100.\nN30 X20.25\nM30\n%\n",
         *       "revision": 1
         *     }
         */
        CompareText: {
            /** @description the whole text */
            text?: string | null;
            /** @description of the stored program; not given: the newest */
            revision?: number | null;
            /** @description whose control counts; not given: the one that each text looks like */
            machine?: string | null;
        };
        /**
         * @description a program, and what it is compared with
         * @example {
         *       "program": 2,
         *       "machine": "lathe",
         *       "nominal": {
         *         "family": "hyperbolic-roll"
         *       }
         *     }
         */
        AccuracyOrder: {
            /** @description id of the program */
            program: number;
            /** @description of the program's text; not given: the newest */
            revision?: number | null;
            /** @description name of the machine */
            machine: string;
            /**
             * @description how the text is sent to the control; not given: drip
             * @enum {string|null}
             */
            delivery?: "drip" | "memory" | null;
            /** @description what the program should make; not given: of a rendered program its family */
            nominal?: {
                /** @description name of the part family whose nominal counts */
                family: string;
                /** @description by parameter, with their units ("120 mm"); what is not given has the family's default */
                values?: {
                    [key: string]: string | number;
                } | null;
            } | null;
            /** @description lines that cut the nominal, as "12-60,70-71"; not given: all cuts */
            profile?: string | null;
            /** @description text of a CSV of measured points */
            cmm?: string | null;
            /** @description the points are shifted and turned to fit best, too */
            best_fit?: boolean | null;
        };
        /**
         * @description a program, and what it is compared with
         * @example {
         *       "program": 2,
         *       "machine": "lathe",
         *       "nominal": {
         *         "family": "hyperbolic-roll"
         *       }
         *     }
         */
        GougeOrder: {
            /** @description id of the program */
            program: number;
            /** @description of the program's text; not given: the newest */
            revision?: number | null;
            /** @description name of the machine */
            machine: string;
            /**
             * @description how the text is sent to the control; not given: drip
             * @enum {string|null}
             */
            delivery?: "drip" | "memory" | null;
            /** @description what the program should make; not given: of a rendered program its family */
            nominal?: {
                /** @description name of the part family whose nominal counts */
                family: string;
                /** @description by parameter, with their units ("120 mm"); what is not given has the family's default */
                values?: {
                    [key: string]: string | number;
                } | null;
            } | null;
            /** @description lines that cut the nominal, as "12-60,70-71"; not given: all cuts */
            profile?: string | null;
        };
        /**
         * @description a program, its machine and line
         * @example {
         *       "program": 3,
         *       "machine": "lathe",
         *       "delivery": "memory"
         *     }
         */
        TimingOrder: {
            /** @description id of the program */
            program: number;
            /** @description of the program's text; not given: the newest */
            revision?: number | null;
            /** @description name of the machine */
            machine: string;
            /**
             * @description how the text is sent to the control; not given: drip
             * @enum {string|null}
             */
            delivery?: "drip" | "memory" | null;
            /** @description what the program should make; not given: of a rendered program its family */
            nominal?: {
                /** @description name of the part family whose nominal counts */
                family: string;
                /** @description by parameter, with their units ("120 mm"); what is not given has the family's default */
                values?: {
                    [key: string]: string | number;
                } | null;
            } | null;
            /** @description lines that cut the nominal, as "12-60,70-71"; not given: all cuts */
            profile?: string | null;
            /** @description of the line, in bit/s; not given: the profile's */
            baud?: number | null;
        };
        /**
         * @description a family, and how it is tried
         * @example {
         *       "family": "hyperbolic-roll",
         *       "machine": "lathe",
         *       "samples": 0,
         *       "values": {
         *         "half_axis_x": "100 mm",
         *         "half_axis_z": "202.4 mm",
         *         "roll_length": "196 mm",
         *         "angle_step": "2 deg",
         *         "clearance": "25 mm",
         *         "cut_feed": "0.15 mm/rev"
         *       }
         *     }
         */
        SweepOrder: {
            /** @description name of a part family */
            family: string;
            /** @description by parameter, with their units ("120 mm"); what is not given has the family's default */
            values?: {
                [key: string]: string | number;
            } | null;
            /** @description name of the machine */
            machine: string;
            /**
             * @description macro: the control computes, explicit: dripfeed computes; not given: auto
             * @enum {string|null}
             */
            mode?: "macro" | "explicit" | "auto" | null;
            /**
             * @description how the text is sent to the control; not given: drip
             * @enum {string|null}
             */
            delivery?: "drip" | "memory" | null;
            /** @description of the random values */
            seed?: number | null;
            /** @description how many random values are tried */
            samples?: number | null;
        };
        /**
         * @description what a release binds
         * @example {
         *       "program": 77,
         *       "machine": "lathe-1",
         *       "delivery": "drip"
         *     }
         */
        NewRelease: {
            /** @description id of the program */
            program: number;
            /** @description of the program's text; not given: the newest */
            revision?: number | null;
            /** @description name of the machine */
            machine: string;
            /**
             * @description how the text is sent to the control; not given: drip
             * @enum {string|null}
             */
            delivery?: "drip" | "memory" | null;
        };
        /**
         * @description one step of a release
         * @example {
         *       "to": "proving",
         *       "transfers": 3
         *     }
         */
        ReleaseMove: {
            /**
             * @description state of the release after this step
             * @enum {string}
             */
            to: "draft" | "in_review" | "proving" | "approved" | "obsolete";
            /** @description for the record; of an approval the sign-off */
            note?: string | null;
            /** @description that may be made while it is proved; needed for proving, of a restart 1 */
            transfers?: number | null;
            /** @description of a restart: of the text that was shown; needed for its proving */
            shown_sha256?: string | null;
        };
        /**
         * @description where a program is to be restarted
         * @example {
         *       "line": 8
         *     }
         */
        RestartOrder: {
            /** @description of the released text that is to be the first one of the rest, from 1 */
            line: number;
            /** @description above the start, where the program has no level of its own above it; not given: 2 */
            clearance_mm?: number | null;
        };
        /**
         * @description a restart that was shown
         * @example {
         *       "line": 8,
         *       "shown_sha256": "8dcd2a66871ee5b2fcc687800337be684cc4e5dc400b6f4ac24fde778d46051f"
         *     }
         */
        NewRestart: {
            /** @description of the released text that is to be the first one of the rest, from 1 */
            line: number;
            /** @description above the start, where the program has no level of its own above it; not given: 2 */
            clearance_mm?: number | null;
            /** @description of the text that was shown */
            shown_sha256: string;
        };
        /**
         * @description for how long an alarm asks for no person
         * @example {
         *       "minutes": 5,
         *       "reason": "the cable is ordered"
         *     }
         */
        Shelve: {
            /** @description for which it asks for no person */
            minutes: number;
            /** @description for the record */
            reason: string;
        };
        /**
         * @description a person answers for a verdict, or for a point of it
         * @example {
         *       "reason": "seen"
         *     }
         */
        NewWaiver: {
            /** @description for the record */
            reason: string;
            /** @description one of the verdict's points, as it stands there; not given: all of it */
            point?: string | null;
            /** @description from then on it no longer counts, in milliseconds since 1970; not given: it does not end */
            expires_at_ms?: number | null;
        };
        /**
         * @description which server gets a machine's line, and why
         * @example {
         *       "node": "hall-2",
         *       "reason": "the machine moves to hall 2"
         *     }
         */
        HandOver: {
            /** @description name of the server that gets the line, as GET /nodes lists it */
            node: string;
            /** @description for the record */
            reason: string;
        };
        /**
         * @description what an operator states of a proving
         * @example {
         *       "note": "first part measured, all sizes in the middle"
         *     }
         */
        SignOff: {
            /** @description what the operator has seen and measured */
            note: string;
        };
        /**
         * @description why a person does it
         * @example {
         *       "reason": "the control was reset"
         *     }
         */
        Reason: {
            /** @description for the record */
            reason: string;
        };
        /**
         * @description why a person does it, where they state it
         * @example {
         *       "reason": "looked at it"
         *     }
         */
        OptionalReason: {
            /** @description for the record */
            reason?: string | null;
        };
        /**
         * @description who receives which events
         * @example {
         *       "url": "https://mes.shop/dripfeed",
         *       "types": [
         *         "job.*",
         *         "alarm.raised"
         *       ],
         *       "description": "the MES"
         *     }
         */
        NewWebhook: {
            /** @description where events are posted: https, or http where it is local */
            url: string;
            /** @description of events that it gets; "job.*": all of a group, "*": all */
            types: string[];
            /** @description for people */
            description?: string | null;
            /** @description whether events are sent; not given: true */
            enabled?: boolean | null;
            /** @description it may lie in a private network or on the server's computer; not given in a new one: false */
            local?: boolean | null;
        };
        /**
         * @description what is not given stays unchanged
         * @example {
         *       "description": "the MES"
         *     }
         */
        ChangedWebhook: {
            /** @description where events are posted from now on */
            url?: string | null;
            /** @description of events that it gets; "job.*": all of a group, "*": all */
            types?: string[] | null;
            /** @description for people */
            description?: string | null;
            /** @description whether events are sent; what happened while they were not is not sent later */
            enabled?: boolean | null;
            /** @description it may lie in a private network or on the server's computer; not given in a new one: false */
            local?: boolean | null;
        };
        /**
         * @description how a secret is changed
         * @example {
         *       "keep_hours": 1
         *     }
         */
        Rotate: {
            /** @description for which the previous secret also signs; 0: it is void at once; not given: 24 */
            keep_hours?: number | null;
        };
        /**
         * @description which dead deliveries are tried again
         * @example {
         *       "since_ms": 1795879637984
         *     }
         */
        Replay: {
            /** @description events that happened then or later, in milliseconds since 1970 */
            since_ms: number;
        };
        /**
         * @description what a receipt becomes; nothing: a new program
         * @example {
         *       "program": 1,
         *       "revision": 1
         *     }
         */
        AcceptOrder: {
            /** @description id of the program that gets a new revision; not given: a new program */
            program?: number | null;
            /** @description the newest of that program, as the caller knows it */
            revision?: number | null;
            /** @description of a new program; not given: the receipt's */
            name?: string | null;
            /** @description for the record */
            reason?: string | null;
        };
        /**
         * @description who signs in: a token, or a name with a password or PIN
         * @example {
         *       "name": "olga",
         *       "password": "correct horse battery"
         *     }
         */
        NewSession: {
            /** @description as `dripfeed token add` printed it; or a name with a password or PIN */
            token?: string | null;
            /** @description of the user, with a password or PIN */
            name?: string | null;
            /** @description of the user */
            password?: string | null;
            /** @description of the user, for the shop floor: it gives no more than the role operator, and a short session */
            pin?: string | null;
        };
        /**
         * @description what the provider added to the address at which the browser came back
         * @example {
         *       "code": "SplxlOBeZQQYbYS6WxSbIA",
         *       "state": "af0ifjsldkj",
         *       "iss": "https://login.shop"
         *     }
         */
        ProviderAnswer: {
            /** @description as it came; not given: the provider refused */
            code?: string | null;
            /** @description as it came */
            state: string;
            /** @description as it came; not given: it did not come */
            iss?: string | null;
            /** @description as it came; not given: there was none */
            error?: string | null;
        };
        /**
         * @description a person
         * @example {
         *       "name": "hall-viewer",
         *       "role": "viewer",
         *       "grants": [
         *         {
         *           "group": "hall",
         *           "role": "viewer"
         *         }
         *       ]
         *     }
         */
        NewUser: {
            /** @description with which the person signs in */
            name: string;
            /**
             * @description each may do what those before it may
             * @enum {string}
             */
            role: "viewer" | "operator" | "programmer" | "approver" | "admin";
            /** @description roles on the machines of groups, instead of "role" */
            grants?: {
                /** @description name of a group of machines */
                group: string;
                /**
                 * @description on the machines of that group
                 * @enum {string}
                 */
                role: "viewer" | "operator" | "programmer" | "approver" | "admin";
            }[] | null;
        };
        /**
         * @description all roles of a user, and whether the user is disabled
         * @example {
         *       "role": "programmer",
         *       "disabled": true
         *     }
         */
        UserChange: {
            /**
             * @description each may do what those before it may
             * @enum {string}
             */
            role: "viewer" | "operator" | "programmer" | "approver" | "admin";
            /** @description roles on the machines of groups, instead of "role" */
            grants?: {
                /** @description name of a group of machines */
                group: string;
                /**
                 * @description on the machines of that group
                 * @enum {string}
                 */
                role: "viewer" | "operator" | "programmer" | "approver" | "admin";
            }[] | null;
            /** @description whether the user may no longer sign in; not given: false */
            disabled?: boolean | null;
        };
        /**
         * @description a new password or PIN
         * @example {
         *       "secret": "the first of olga"
         *     }
         */
        NewSecret: {
            /** @description the new password (10 bytes or more) or PIN (4 to 12 digits) */
            secret: string;
        };
        /**
         * @description the present password and a new one
         * @example {
         *       "current": "the first of olga",
         *       "secret": "the third of olga"
         *     }
         */
        OwnSecret: {
            /** @description the present password */
            current: string;
            /** @description the new password (10 bytes or more) or PIN (4 to 12 digits) */
            secret: string;
        };
        /**
         * @description a token: of a user or of a program; "scope" limits what it may change
         * @example {
         *       "name": "the MES",
         *       "role": "operator",
         *       "scope": [
         *         "queue"
         *       ]
         *     }
         */
        NewToken: {
            /** @description of the program or station that gets it */
            name: string;
            /**
             * @description each may do what those before it may
             * @enum {string}
             */
            role: "viewer" | "operator" | "programmer" | "approver" | "admin";
            /** @description name of a person whose rights it has, up to its role; not given: a program's own */
            user?: string | null;
            /** @description what it may change: library, checks, releases, queue, line, setup; not given: all that its role may */
            scope?: string[] | null;
            /** @description until when it is valid, in milliseconds since 1970; not given: it does not end */
            expires_at_ms?: number | null;
        };
        /**
         * @description all machines of a group, none of which is in another one, and its rules; a rule that is not given stays
         * @example {
         *       "machines": [
         *         "lathe",
         *         "second",
         *         "third"
         *       ]
         *     }
         */
        GroupChange: {
            /** @description names of all machines of the group */
            machines?: string[] | null;
            /** @description whether a person who wrote or released a text may not approve it on these machines; not given: the rule stays, at first false */
            four_eyes?: boolean | null;
            /** @description whether an operator signs a proving off before a release is approved for these machines; not given: the rule stays, at first true */
            operator_sign_off?: boolean | null;
        };
        /**
         * @description which release is transferred, and when it may be
         * @example {
         *       "release": 17,
         *       "order": 31,
         *       "not_before_ms": 1795500450000,
         *       "end_check": "part taken out"
         *     }
         */
        NewJob: {
            /** @description id of the release */
            release: number;
            /** @description id of the order that it belongs to; not given: none */
            order?: number | null;
            /** @description before this time it is armed only with a reason, in ms since 1970; not given: at any time */
            not_before_ms?: number | null;
            /** @description what a person confirms after the end of a job, before the next one of the machine is armed; of a profile: after each drip feed; not given: nothing, or what the machine's profile asks for */
            end_check?: string | null;
        };
        /**
         * @description which program is queued for a group of machines
         * @example {
         *       "program": 1,
         *       "order": 1,
         *       "end_check": "part taken out"
         *     }
         */
        NewChoice: {
            /** @description its id */
            program: number;
            /** @description of its text; not given: the newest */
            revision?: number | null;
            /**
             * @description how the text is sent to the control; not given: drip
             * @enum {string|null}
             */
            delivery?: "drip" | "memory" | null;
            /** @description id of the order that it belongs to; not given: none */
            order?: number | null;
            /** @description before this time it is armed only with a reason, in ms since 1970; not given: at any time */
            not_before_ms?: number | null;
            /** @description what a person confirms after the end of a job, before the next one of the machine is armed; of a profile: after each drip feed; not given: nothing, or what the machine's profile asks for */
            end_check?: string | null;
        };
        /**
         * @description how a job is armed
         * @example {
         *       "minutes": 10
         *     }
         */
        ArmOrder: {
            /** @description until the arming ends by itself; not given: the profile's */
            minutes?: number | null;
            /** @description how often the text is sent; each waits for the control's own start */
            rounds?: number | null;
            /** @description why it is armed before its time, by an approver; not given: it is not */
            early_reason?: string | null;
        };
        /**
         * @description the new place of a queued job
         * @example {
         *       "before": 1
         *     }
         */
        Move: {
            /** @description id of the queued job of the same machine that it is moved before; null, or not given: to the end */
            before?: number | null;
        };
        /**
         * @description when a queued job may be armed
         * @example {
         *       "not_before_ms": 1795879524784
         *     }
         */
        JobSchedule: {
            /** @description before this time it is armed only with a reason, in ms since 1970; not given: at any time */
            not_before_ms?: number | null;
        };
        /**
         * @description why a transfer stood still or broke off
         * @example {
         *       "reason": "tool broken",
         *       "note": "insert of T3"
         *     }
         */
        NewStopReason: {
            /** @description for the record */
            reason: string;
            /** @description for the record; of an approval the sign-off */
            note?: string | null;
        };
        /**
         * @description a person has done what the job's end asks for
         * @example {
         *       "note": "on the table"
         *     }
         */
        JobEnd: {
            /** @description for people */
            note?: string | null;
        };
        /**
         * @description what is to be made
         * @example {
         *       "number": "4711",
         *       "operation": "20",
         *       "part": "HUB-12",
         *       "quantity": 50,
         *       "machine": "lathe-1",
         *       "due_at_ms": 1795600800000,
         *       "priority": 10,
         *       "metadata": {
         *         "cost_center": "A7"
         *       }
         *     }
         */
        NewOrder: {
            /** @description of the planner */
            number: string;
            /** @description of the routing; not given: none */
            operation?: string | null;
            /** @description number of the part */
            part: string;
            /** @description good parts that are wanted */
            quantity: number;
            /** @description name of the machine */
            machine?: string | null;
            /** @description until when, in milliseconds since 1970; not given: no date */
            due_at_ms?: number | null;
            /** @description the higher the sooner; not given: 0 */
            priority?: number | null;
            /** @description the planner's own data; they come back as they were given */
            metadata?: {
                [key: string]: unknown;
            } | null;
        };
        /**
         * @description the new plan of an order, as a whole
         * @example {
         *       "part": "R-1",
         *       "quantity": 7,
         *       "machine": null,
         *       "due_at_ms": null,
         *       "priority": 3,
         *       "metadata": {
         *         "customer": "ACME",
         *         "n": 1.5
         *       }
         *     }
         */
        OrderPlan: {
            /** @description number of the part */
            part: string;
            /** @description good parts that are wanted */
            quantity: number;
            /** @description name of the machine */
            machine?: string | null;
            /** @description until when, in milliseconds since 1970; not given: no date */
            due_at_ms?: number | null;
            /** @description the higher the sooner; not given: 0 */
            priority?: number | null;
            /** @description the planner's own data; they come back as they were given */
            metadata?: {
                [key: string]: unknown;
            } | null;
        };
        /**
         * @description one step of an order
         * @example {
         *       "to": "held",
         *       "reason": "the material is late"
         *     }
         */
        OrderMove: {
            /**
             * @description the state
             * @enum {string}
             */
            to: "open" | "held" | "done" | "cancelled";
            /** @description needed to hold and to cancel */
            reason?: string | null;
        };
        /**
         * @description parts that were made since the last report
         * @example {
         *       "good": 12,
         *       "scrap": 1,
         *       "note": "one had a burr"
         *     }
         */
        PartsReport: {
            /** @description parts; not given: 0 */
            good?: number | null;
            /** @description parts; not given: 0 */
            scrap?: number | null;
            /** @description for people */
            note?: string | null;
        };
        /**
         * @description a machine: its control, axes, tools and line
         * @example {
         *       "name": "other",
         *       "title": "Machining centre with Fanuc 0i-MF",
         *       "dialect": "fanuc",
         *       "kind": "mill",
         *       "axes": [
         *         {
         *           "name": "X",
         *           "min_mm": 0,
         *           "max_mm": 800,
         *           "reference_mm": 800,
         *           "rapid_mm_min": 30000,
         *           "acceleration_mm_s2": 3000
         *         },
         *         {
         *           "name": "Y",
         *           "min_mm": 0,
         *           "max_mm": 500,
         *           "reference_mm": 500,
         *           "rapid_mm_min": 30000,
         *           "acceleration_mm_s2": 3000
         *         },
         *         {
         *           "name": "Z",
         *           "min_mm": -500,
         *           "max_mm": 0,
         *           "reference_mm": 0,
         *           "rapid_mm_min": 30000,
         *           "acceleration_mm_s2": 3000
         *         }
         *       ],
         *       "feed_limit_mm_min": 10000,
         *       "spindle": {
         *         "min_rpm": 50,
         *         "max_rpm": 10000
         *       },
         *       "tools": [
         *         {
         *           "number": 1,
         *           "offset": 1,
         *           "diameter_mm": 10,
         *           "length_mm": 100,
         *           "holder": [
         *             {
         *               "from_mm": 38,
         *               "diameter_mm": 32
         *             },
         *             {
         *               "from_mm": 73,
         *               "diameter_mm": 63
         *             }
         *           ]
         *         },
         *         {
         *           "number": 2,
         *           "offset": 2,
         *           "diameter_mm": 6,
         *           "length_mm": 90,
         *           "holder": [
         *             {
         *               "from_mm": 34,
         *               "diameter_mm": 28
         *             },
         *             {
         *               "from_mm": 63,
         *               "diameter_mm": 63
         *             }
         *           ]
         *         },
         *         {
         *           "number": 3,
         *           "offset": 3,
         *           "diameter_mm": 50,
         *           "length_mm": 80,
         *           "holder": [
         *             {
         *               "from_mm": 40,
         *               "diameter_mm": 48
         *             },
         *             {
         *               "from_mm": 53,
         *               "diameter_mm": 63
         *             }
         *           ]
         *         }
         *       ],
         *       "work_offsets": [
         *         {
         *           "number": 1,
         *           "X_mm": 200,
         *           "Y_mm": 200,
         *           "Z_mm": -300
         *         },
         *         {
         *           "number": 2,
         *           "X_mm": 200,
         *           "Y_mm": 200,
         *           "Z_mm": -300
         *         },
         *         {
         *           "number": 3,
         *           "X_mm": 200,
         *           "Y_mm": 200,
         *           "Z_mm": -300
         *         }
         *       ],
         *       "control": {
         *         "title": "Fanuc 0i-MF",
         *         "decimal_mode": "least-increment",
         *         "decimal_mode_confirmed": true,
         *         "power_on": {
         *           "unit": "mm",
         *           "distance": "absolute",
         *           "feed": "per-minute",
         *           "plane": "xy",
         *           "confirmed": true
         *         }
         *       },
         *       "timing": {
         *         "sample_time_ms": 8,
         *         "look_ahead_blocks": 20,
         *         "tool_change_s": 1.5
         *       },
         *       "buffer": {
         *         "bytes": 2048,
         *         "blocks": 0
         *       },
         *       "link": {
         *         "url": "serial:/dev/serial/by-id/usb-FTDI-lathe",
         *         "baud": 9600,
         *         "framing": "7E2",
         *         "code": "iso",
         *         "eob": "lf",
         *         "leader": 50,
         *         "trailer": 50,
         *         "start": "dc1",
         *         "overrun_budget": 10,
         *         "unsent": 3,
         *         "latency_chars": 5,
         *         "character_set": "fanuc-iso"
         *       }
         *     }
         */
        Profile: {
            /** @description what the shop calls the machine; also its id */
            name: string;
            /** @description for people */
            title?: string | null;
            /** @description what a person confirms after the end of a job, before the next one of the machine is armed; of a profile: after each drip feed; not given: nothing, or what the machine's profile asks for */
            end_check?: string | null;
            /** @description of the control: fanuc, haas, mazak, mitsubishi-m80 or sinumerik-840d */
            dialect: string;
            /** @description where the values are from, and what is assumed */
            notes?: string[] | null;
            /**
             * @description of machine
             * @enum {string}
             */
            kind: "mill" | "lathe" | "mill-turn";
            /** @description that the machine has */
            axes: {
                /**
                 * @description letter of the axis
                 * @enum {string}
                 */
                name: "X" | "Y" | "Z" | "A" | "B" | "C" | "U" | "V" | "W";
                /** @description least position of the slide in machine coordinates, mm or degrees; not given: not known */
                min_mm?: number | null;
                /** @description greatest position of the slide in machine coordinates, mm or degrees; not given: not known */
                max_mm?: number | null;
                /** @description programs and work offsets state this axis as a diameter */
                diameter?: boolean | null;
                /** @description speed of rapid motion, mm/min or degrees/min */
                rapid_mm_min: number;
                /** @description greatest feed of this axis alone; not given: its rapid */
                feed_limit_mm_min?: number | null;
                /** @description of the axis, mm/s² or degrees/s² */
                acceleration_mm_s2: number;
                /** @description of the axis, mm/s³ or degrees/s³; 0: not limited */
                jerk_mm_s3?: number | null;
                /** @description reference point of G28 in machine coordinates; not given: not known */
                reference_mm?: number | null;
                /** @description second reference point of G30 in machine coordinates; not given: not known */
                second_reference_mm?: number | null;
            }[];
            /** @description greatest feed along the path; 0: not known */
            feed_limit_mm_min?: number | null;
            /** @description its limits; not given: not known */
            spindle?: {
                /** @description least speed */
                min_rpm?: number | null;
                /** @description greatest speed */
                max_rpm: number;
            } | null;
            /** @description in the magazine or turret */
            tools?: {
                /** @description by which programs call it; of one that they call by name: any that no other tool has */
                number: number;
                /** @description by which SINUMERIK programs call it, as T="MILL_D10"; capital letters count; not given: they call it by number */
                name?: string | null;
                /** @description the offset or D number that holds its figures */
                offset?: number | null;
                /** @description of a turning tool */
                nose_radius_mm?: number | null;
                /** @description where the imaginary tip lies, 0 to 9, as Fanuc and SINUMERIK number it */
                tip?: number | null;
                /** @description of a mill or drill */
                diameter_mm?: number | null;
                /** @description of a mill or drill: from the spindle's gauge line to the tip */
                length_mm?: number | null;
                /** @description of a turning tool: how far the slide lies beyond the tip, as a radius */
                length_x_mm?: number | null;
                /** @description of a turning tool: how far the slide lies beyond the tip */
                length_z_mm?: number | null;
                /** @description of a mill: 0 is flat, half the diameter a ball */
                corner_radius_mm?: number | null;
                /** @description of a turning tool: its insert, for pictures; the gouge check counts the nose alone */
                insert?: {
                    /** @description between the two edges at the nose: 80 of a C insert, 55 D, 35 V, 60 T */
                    angle_deg: number;
                    /** @description of the leading edge against the direction of feed, as 95; of tips 5 to 8 it does not count */
                    entering_angle_deg: number;
                    /** @description length of a cutting edge */
                    edge_mm: number;
                } | null;
                /** @description of a mill: its shank and holder, from below; a holder in the workpiece is a fault; not given: not checked */
                holder?: {
                    /** @description height above the tip from which on it is this wide, up to the next step or the spindle */
                    from_mm: number;
                    /** @description of a mill or drill */
                    diameter_mm: number;
                }[] | null;
            }[] | null;
            /** @description where the work zero lies where `work_offsets` states nothing; machine coordinates */
            origin?: {
                /** @description of the slide, never a diameter; not given: not known */
                X_mm?: number | null;
                /** @description of the slide; not given: not known */
                Y_mm?: number | null;
                /** @description of the slide; not given: not known */
                Z_mm?: number | null;
                /** @description in degrees; not given: not known */
                A_mm?: number | null;
                /** @description in degrees; not given: not known */
                B_mm?: number | null;
                /** @description in degrees; not given: not known */
                C_mm?: number | null;
                /** @description of the slide; not given: not known */
                U_mm?: number | null;
                /** @description of the slide; not given: not known */
                V_mm?: number | null;
                /** @description of the slide; not given: not known */
                W_mm?: number | null;
            } | null;
            /** @description where each puts its zero; machine coordinates */
            work_offsets?: {
                /** @description 1 is G54 */
                number: number;
                /** @description of the slide, never a diameter; not given: not known */
                X_mm?: number | null;
                /** @description of the slide; not given: not known */
                Y_mm?: number | null;
                /** @description of the slide; not given: not known */
                Z_mm?: number | null;
                /** @description in degrees; not given: not known */
                A_mm?: number | null;
                /** @description in degrees; not given: not known */
                B_mm?: number | null;
                /** @description in degrees; not given: not known */
                C_mm?: number | null;
                /** @description of the slide; not given: not known */
                U_mm?: number | null;
                /** @description of the slide; not given: not known */
                V_mm?: number | null;
                /** @description of the slide; not given: not known */
                W_mm?: number | null;
            }[] | null;
            /** @description of the control, for programs that are fed; not given: not known */
            buffer?: {
                /** @description how many it holds; 0: not limited */
                bytes?: number | null;
                /** @description how many it holds; 0: not limited */
                blocks?: number | null;
            } | null;
            /** @description how fast the control works */
            timing?: {
                /** @description cycle time of the interpolator; 0: not known */
                sample_time_ms?: number | null;
                /** @description how many blocks the control plans ahead; 0: not limited */
                look_ahead_blocks?: number | null;
                /** @description how long one tool change takes */
                tool_change_s?: number | null;
                /** @description within which the control rounds corners; 0: it rounds none */
                contour_tolerance_mm?: number | null;
                /** @description how long the control computes, ms for each; not given: its usual times */
                cost?: {
                    /** @description a block */
                    block_ms: number;
                    /** @description reading a numbered variable: R, # */
                    number_read_ms?: number | null;
                    /** @description writing a numbered variable */
                    number_write_ms?: number | null;
                    /** @description reading a variable with a name: LUD, PUD, GUD, system */
                    named_read_ms?: number | null;
                    /** @description writing a variable with a name */
                    named_write_ms?: number | null;
                    /** @description an operator */
                    operator_ms?: number | null;
                    /** @description a function */
                    function_ms?: number | null;
                    /** @description a jump that is taken, in addition to its block */
                    jump_ms?: number | null;
                    /** @description the end of a loop's round */
                    round_ms?: number | null;
                    /** @description calling a program and returning, in addition to the two blocks */
                    call_ms?: number | null;
                    /** @description finding a variable by a computed number, in addition to reading or writing it */
                    indexed_ms?: number | null;
                    /** @description a predicted computing time may be off by this factor, in either direction; not given: 5 */
                    spread?: number | null;
                    /**
                     * @description where the figures are from: assumed, paper, or calibrated at this machine; not given: assumed
                     * @enum {string|null}
                     */
                    source?: "assumed" | "paper" | "calibrated" | null;
                    /** @description in words: which paper, or which timing program and when */
                    origin?: string | null;
                } | null;
            } | null;
            /** @description how this machine's control differs from the usual one */
            control?: {
                /** @description of the control, for people */
                title?: string | null;
                /**
                 * @description G code system of a lathe
                 * @enum {string|null}
                 */
                g_system?: "A" | "B" | "C" | null;
                /**
                 * @description what a number without a point is: millimeters, or least increments
                 * @enum {string|null}
                 */
                decimal_mode?: "calculator" | "least-increment" | null;
                /** @description a person looked at the machine */
                decimal_mode_confirmed?: boolean | null;
                /** @description how a SINUMERIK reads ISO mode (G291) */
                iso_mode?: {
                    /**
                     * @description what a number without a point is: millimeters, or least increments
                     * @enum {string|null}
                     */
                    decimal_mode?: "calculator" | "least-increment" | null;
                    /** @description a person looked at the machine */
                    decimal_mode_confirmed?: boolean | null;
                    /** @description G291 is in effect where a program begins */
                    from_start?: boolean | null;
                } | null;
                /** @description least increment of the axes: positions are rounded to it; 0: not stated */
                increment_mm?: number | null;
                /** @description longest block that the control takes; not given: its usual limit */
                block_length_bytes?: number | null;
                /** @description how many axes one block may move; not given: all */
                axes_at_once?: number | null;
                /**
                 * @description what an arc without I, J, K and R is
                 * @enum {string|null}
                 */
                arc_without_center?: "alarm" | "line" | null;
                /** @description M functions of the machine that move no axis and change no mode, as "10-19, 25"; empty: none is known to */
                machine_functions?: string | null;
                /** @description G and M codes that parameters turn into calls */
                code_calls?: {
                    /** @description as "G100" */
                    code: string;
                    /** @description number of the program that is called */
                    program: number;
                    /** @description called as a macro, with arguments */
                    macro?: boolean | null;
                }[] | null;
                /** @description how deeply the control takes calls and loops; not given: its usual limits */
                nesting?: {
                    /** @description levels of subprograms */
                    calls?: number | null;
                    /** @description levels of macro calls */
                    macros?: number | null;
                    /** @description levels of loops */
                    loops?: number | null;
                } | null;
                /** @description by how much an arc's radius may change from start to end */
                arcs?: {
                    /** @description the greatest change */
                    tolerance_mm?: number | null;
                    /** @description or this part of the radius, where that is more */
                    tolerance_factor?: number | null;
                } | null;
                /** @description of a SINUMERIK: the fixed point (G75 FP=) that lies where other controls move by G28 */
                reference_fixed_point?: number | null;
                /** @description a person compared a spline of the machine with that of dripfeed */
                splines_confirmed?: boolean | null;
                /** @description parameters of cycles; not given: the control's usual ones */
                cycles?: {
                    /** @description by which a drill retracts to break the chip */
                    chip_break_mm?: number | null;
                    /** @description how far above the last depth the next peck begins its feed */
                    peck_clearance_mm?: number | null;
                    /** @description depth of one cut of a turning cycle, as a radius */
                    turning_depth_mm?: number | null;
                    /** @description retract after one cut of a turning cycle, as a radius */
                    turning_retract_mm?: number | null;
                } | null;
                /** @description modes at power-on; not given: the control's usual ones */
                power_on?: {
                    /**
                     * @description of lengths
                     * @enum {string|null}
                     */
                    unit?: "mm" | "inch" | null;
                    /**
                     * @description of positions
                     * @enum {string|null}
                     */
                    distance?: "absolute" | "incremental" | null;
                    /**
                     * @description of feeds
                     * @enum {string|null}
                     */
                    feed?: "per-minute" | "per-revolution" | null;
                    /**
                     * @description of arcs
                     * @enum {string|null}
                     */
                    plane?: "xy" | "zx" | "yz" | null;
                    /** @description a person looked at the machine */
                    confirmed?: boolean | null;
                } | null;
                /** @description ranges that the control has; empty: its usual ones */
                variables?: {
                    /**
                     * @description # or R
                     * @enum {string|null}
                     */
                    bank?: "#" | "R" | null;
                    /** @description first number of the range */
                    first?: number | null;
                    /** @description last number of the range */
                    last?: number | null;
                    /**
                     * @description what the variables of this range are
                     * @enum {string|null}
                     */
                    use?: "local" | "common" | "permanent" | "system" | null;
                    /** @description programs may set them */
                    writable?: boolean | null;
                }[] | null;
            } | null;
            /** @description how the control is reached */
            link: {
                /** @description serial:/dev/serial/by-id/NAME, tcp://host:port, rfc2217://host:port, modbus-tcp://host:port/unit, dir:/folder and others (connecting.md) */
                url: string;
                /**
                 * @description what the line speaks; not given: dc-codes
                 * @enum {string|null}
                 */
                protocol?: "dc-codes" | "remote-buffer-b" | "xmodem" | "xmodem-crc" | "xmodem-1k" | "remote-buffer-a" | "3964" | "3964r" | "ymodem" | null;
                /** @description in bit/s; not given: 9600 */
                baud?: number | null;
                /** @description data bits, parity, stop bits: "7E2", "8N1"; not given: 7E2, for a packet protocol 8N1 */
                framing?: string | null;
                /**
                 * @description of the characters on the line; not given: iso, for a packet protocol ascii
                 * @enum {string|null}
                 */
                code?: "ascii" | "iso" | "eia" | null;
                /** @description codes of the characters that EIA does not have */
                eia_specials?: {
                    /** @description its EIA code */
                    "["?: number | null;
                    /** @description its EIA code */
                    "]"?: number | null;
                    /** @description its EIA code */
                    "#"?: number | null;
                    /** @description its EIA code */
                    "*"?: number | null;
                    /** @description its EIA code */
                    "="?: number | null;
                    /** @description its EIA code */
                    ":"?: number | null;
                } | null;
                /** @description end of block: lf, cr-lf, lf-cr-cr, cr, or up to four of lf, cr and hex codes, as cr-lf-lf; not given: lf */
                eob?: string | null;
                /** @description TV check: a blank makes the number of characters of a block even where it is odd; not given: false */
                pad_tv?: boolean | null;
                /**
                 * @description character of leader and trailer; not given: nul
                 * @enum {string|null}
                 */
                filler?: "nul" | "del" | null;
                /** @description characters before the text; not given: 0 */
                leader?: number | null;
                /** @description characters after the text; not given: 0 */
                trailer?: number | null;
                /**
                 * @description what starts a transfer; not given: dc1
                 * @enum {string|null}
                 */
                start?: "dc1" | "at-once" | "trigger" | null;
                /** @description of a start by trigger: what the control sends */
                start_trigger?: string | null;
                /**
                 * @description what holds the sender; not given: xonxoff, for a packet protocol none
                 * @enum {string|null}
                 */
                flow?: "none" | "xonxoff" | "rtscts" | "dtrdsr" | "both" | null;
                /**
                 * @description who obeys XOFF; not given: host
                 * @enum {string|null}
                 */
                xoff_by?: "host" | "kernel" | "device" | null;
                /** @description code of XON (DC1); not given: 17 */
                xon?: number | null;
                /** @description code of XOFF (DC3); not given: 19 */
                xoff?: number | null;
                /** @description additional, between two characters; not given: 0 */
                char_delay_ms?: number | null;
                /** @description additional, after each EOB; not given: 0 */
                line_delay_ms?: number | null;
                /** @description DC3 after the last character ends the transfer; not given: true */
                end_by_dc3?: boolean | null;
                /** @description code of a character by which the control ends the transfer */
                end_by_character?: number | null;
                /** @description the transfer has ended when the control sent nothing for so long; not given: 5 */
                end_by_quiet_s?: number | null;
                /** @description characters that the control takes after its DC3; not given: 10 */
                overrun_budget?: number | null;
                /** @description characters that may wait in the port; not given: 4 */
                unsent?: number | null;
                /** @description characters that may still leave before a DC3 is obeyed; not given: 5 */
                latency_chars?: number | null;
                /** @description CTS holds the sender; not given: false */
                watch_cts?: boolean | null;
                /** @description DSR holds the sender; not given: false */
                watch_dsr?: boolean | null;
                /** @description how long an answer of a packet protocol may take; not given: without limit */
                answer_s?: number | null;
                /** @description bytes of the text in one packet; not given: 128 */
                payload_bytes?: number | null;
                /** @description 3964: frames carry a number; not given: false */
                counted_frames?: boolean | null;
                /** @description 3964: where both sides want to send at once, this one lets the control send first; not given: true */
                gives_way?: boolean | null;
                /** @description remote buffer: messages end with CR instead of ETX; not given: false */
                messages_end_with_cr?: boolean | null;
                /** @description until an arming ends by itself; not given: 10 */
                arming_minutes?: number | null;
                /**
                 * @description that the control takes; not given: ascii
                 * @enum {string|null}
                 */
                character_set?: "iso-core" | "fanuc-iso" | "mitsubishi" | "mazak" | "sinumerik" | "ascii" | null;
            };
            /** @description how programs that the control punches are taken */
            receive?: {
                /** @description they are taken at all; not given: true */
                enabled?: boolean | null;
                /** @description a program has ended when the control sent nothing for so long; not given: 5 */
                quiet_s?: number | null;
                /** @description the same, after the final %; not given: 0.5 */
                quiet_after_end_s?: number | null;
                /** @description code of a character that ends it */
                end_character?: number | null;
                /**
                 * @description line: as the link's; auto: it is found out from what comes; not given: line
                 * @enum {string|null}
                 */
                code?: "line" | "auto" | null;
                /**
                 * @description how the control's output is held while the server cannot keep up; not given: none
                 * @enum {string|null}
                 */
                hold?: "none" | "dc3" | "rts" | null;
                /** @description after a memory load an operator punches the program, and the server compares it; not given: false */
                read_back?: boolean | null;
                /** @description how long the server waits for that punch; not given: 30 */
                read_back_minutes?: number | null;
                /** @description an operator may ask for programs by punching one with the question; not given: true */
                requests?: boolean | null;
                /** @description O number of a request; not given: 9999 */
                request_number?: number | null;
                /** @description O number of an answer; not given: the request's */
                answer_number?: number | null;
                /** @description or a word in the name of a request, where programs have names */
                request_marker?: string | null;
                /** @description how many lines of a request are searched for its verb; not given: 5 */
                scan_lines?: number | null;
                /** @description before an answer starts, where the control does not ask with DC1; not given: 5 */
                request_delay_s?: number | null;
                /** @description an operator may queue a drip feed by a request; not given: false */
                remote_drip?: boolean | null;
                /** @description and arm it: the operator at the control is the person who arms; not given: false */
                remote_arm?: boolean | null;
            } | null;
        };
        /**
         * @description why a line waits; `stopped`: a person stopped it at a block end
         * @enum {string}
         */
        Stall: "waiting for DC1" | "held by DC3" | "CTS off" | "peer gone" | "waiting for ledger" | "waiting for text" | "waiting for end" | "stopped" | "DSR off" | "held below" | "waiting for trigger" | "stopped, and the control asked again: it may have been reset" | "waiting for the receiver's start" | "waiting for the receiver" | "waiting for ACK" | "waiting for the end's ACK" | "the partner sends" | "waiting for credit" | "waiting for receiver" | "stopped by a fault" | "machine held" | "machine alarm" | "machine in emergency stop" | "folder does not answer" | "holding the control: what it sent before is not taken yet" | "waiting for the sender";
        /**
         * @description where a machine's line stands now
         * @example {
         *       "line": "disconnected",
         *       "stall": "peer gone",
         *       "stop_wanted": false,
         *       "link_error": "Connection reset by peer",
         *       "link_error_id": "system",
         *       "link_error_said": null,
         *       "link_note": null,
         *       "link_note_id": null,
         *       "line_errors": {
         *         "parity": 0,
         *         "framing": 0,
         *         "overrun": 0,
         *         "breaks": 0
         *       },
         *       "asks_since_ms": null,
         *       "asks": 0,
         *       "job": 4,
         *       "handed": 27,
         *       "clocked": 0,
         *       "confirmed": 0,
         *       "confirms": false,
         *       "estimated": true,
         *       "total": 51908,
         *       "block_from": 1,
         *       "block": 4,
         *       "holds": 1,
         *       "hold_s": 0.1504,
         *       "line_use": 1,
         *       "plc": null,
         *       "program": "O0042",
         *       "block_text": "G55",
         *       "needs_confirmation": null
         *     }
         */
        MachineStatus: {
            /**
             * @description state of the line
             * @enum {string}
             */
            line: "disconnected" | "idle" | "armed" | "feeding" | "held" | "draining" | "torn" | "receiving" | "answering";
            stall: components["schemas"]["Stall"] | null;
            /** @description a person's stop is in force, reached or not */
            stop_wanted: boolean;
            /** @description why the link is down */
            link_error: string | null;
            /** @description the same as the id of a sentence; `system`: in the system's own words */
            link_error_id: string | null;
            link_error_said: components["schemas"]["Said"] | null;
            /** @description of a link that is up: what its device server did not confirm */
            link_note: string | null;
            /** @description which kind of note it is */
            link_note_id: string | null;
            /** @description what the UART counted since the link is up */
            line_errors: {
                /** @description characters with wrong parity */
                parity: number;
                /** @description characters without a stop bit */
                framing: number;
                /** @description characters that were lost */
                overrun: number;
                /** @description breaks of the line */
                breaks: number;
            };
            /** @description since when the control asks for a program while nothing is armed; milliseconds since 1970, UTC */
            asks_since_ms: number | null;
            /** @description how often it has asked since then */
            asks: number;
            /** @description the last job that was armed here since the server's start */
            job: number | null;
            /** @description given to the system's port, in bytes on the wire */
            handed: number;
            /** @description that have left, by line time, in bytes on the wire */
            clocked: number;
            /** @description that the protocol acknowledged, in bytes on the wire */
            confirmed: number;
            /** @description the protocol acknowledges; without, `confirmed` stays 0 */
            confirms: boolean;
            /** @description a blind link: how much is in transit is an estimate */
            estimated: boolean;
            /** @description of the job, in bytes on the wire */
            total: number;
            /** @description first line of the text where the control may be; 0: not known */
            block_from: number;
            /** @description last line of the text where the control may be; 0: not known */
            block: number;
            /** @description how often the control held the line in this job */
            holds: number;
            /** @description how long it held it, in seconds */
            hold_s: number;
            /** @description share of line time used while not held, 0 to 1 */
            line_use: number;
            /** @description what the machine's PLC reports of it; null where the link has no such words */
            plc: {
                /**
                 * @description of the machine
                 * @enum {string}
                 */
                state: "unknown" | "idle" | "running" | "held" | "alarm" | "emergency stop" | "manual";
                /** @description its number; 0: none, or not known */
                program: number;
                /** @description being executed, from 1; 0: not known */
                line: number;
                /** @description the control's own number; 0: none */
                alarm: number;
            } | null;
            /** @description name of the job's program; empty: no job */
            program: string;
            /** @description the line `block` of the text; empty: not known */
            block_text: string;
            /** @description a block that broke off: nothing is sent until a person confirms that the control was reset */
            needs_confirmation: {
                /** @description whose block it is; null: of an answer, or of another program on the line */
                job: number | null;
                /** @description one sentence for a person */
                text: string;
                said: components["schemas"]["Said"] | null;
                /** @description which kind of reason it is; null: none is known */
                reason_id: string | null;
            } | null;
        };
        /**
         * @description a machine with its whole profile
         * @example {
         *       "name": "lathe",
         *       "revision": 1,
         *       "profile": {
         *         "name": "lathe",
         *         "title": "Lathe with Fanuc 0i-TF",
         *         "dialect": "fanuc",
         *         "notes": [
         *           "Work offsets are those of the tools' tips: their lengths are given as 0."
         *         ],
         *         "kind": "lathe",
         *         "axes": [
         *           {
         *             "name": "X",
         *             "diameter": true,
         *             "min_mm": -20,
         *             "max_mm": 260,
         *             "reference_mm": 260,
         *             "rapid_mm_min": 20000,
         *             "acceleration_mm_s2": 2500
         *           },
         *           {
         *             "name": "Z",
         *             "min_mm": -750,
         *             "max_mm": 50,
         *             "reference_mm": 50,
         *             "rapid_mm_min": 24000,
         *             "acceleration_mm_s2": 2500
         *           }
         *         ],
         *         "feed_limit_mm_min": 8000,
         *         "spindle": {
         *           "min_rpm": 30,
         *           "max_rpm": 4000
         *         },
         *         "tools": [
         *           {
         *             "number": 1,
         *             "offset": 1,
         *             "nose_radius_mm": 0.8,
         *             "tip": 3,
         *             "length_x_mm": 0,
         *             "length_z_mm": 0,
         *             "insert": {
         *               "angle_deg": 80,
         *               "entering_angle_deg": 95,
         *               "edge_mm": 12
         *             }
         *           },
         *           {
         *             "number": 2,
         *             "offset": 2,
         *             "nose_radius_mm": 0.4,
         *             "tip": 3,
         *             "length_x_mm": 0,
         *             "length_z_mm": 0,
         *             "insert": {
         *               "angle_deg": 55,
         *               "entering_angle_deg": 93,
         *               "edge_mm": 15
         *             }
         *           },
         *           {
         *             "number": 3,
         *             "offset": 3,
         *             "nose_radius_mm": 0.1,
         *             "tip": 8,
         *             "length_x_mm": 0,
         *             "length_z_mm": 0
         *           }
         *         ],
         *         "work_offsets": [
         *           {
         *             "number": 1,
         *             "X_mm": 0,
         *             "Z_mm": -400
         *           },
         *           {
         *             "number": 2,
         *             "X_mm": 0,
         *             "Z_mm": -400
         *           },
         *           {
         *             "number": 3,
         *             "X_mm": 0,
         *             "Z_mm": -400
         *           }
         *         ],
         *         "control": {
         *           "title": "Fanuc 0i-TF",
         *           "g_system": "A",
         *           "decimal_mode": "least-increment",
         *           "decimal_mode_confirmed": true,
         *           "power_on": {
         *             "unit": "mm",
         *             "distance": "absolute",
         *             "feed": "per-revolution",
         *             "plane": "zx",
         *             "confirmed": true
         *           }
         *         },
         *         "timing": {
         *           "sample_time_ms": 8,
         *           "look_ahead_blocks": 20,
         *           "tool_change_s": 1.5
         *         },
         *         "buffer": {
         *           "bytes": 2048,
         *           "blocks": 0
         *         },
         *         "link": {
         *           "url": "tcp://10.0.0.21:4001",
         *           "baud": 19200,
         *           "framing": "8N1",
         *           "code": "iso",
         *           "eob": "lf",
         *           "leader": 0,
         *           "trailer": 0,
         *           "start": "dc1",
         *           "overrun_budget": 10,
         *           "unsent": 3,
         *           "latency_chars": 5,
         *           "character_set": "fanuc-iso",
         *           "end_by_quiet_s": 0.3
         *         }
         *       },
         *       "status": {
         *         "line": "torn",
         *         "stall": "peer gone",
         *         "stop_wanted": false,
         *         "link_error": "Connection reset by peer",
         *         "link_error_id": "system",
         *         "link_error_said": null,
         *         "link_note": null,
         *         "link_note_id": null,
         *         "line_errors": {
         *           "parity": 0,
         *           "framing": 0,
         *           "overrun": 0,
         *           "breaks": 0
         *         },
         *         "asks_since_ms": null,
         *         "asks": 0,
         *         "job": 4,
         *         "handed": 27,
         *         "clocked": 0,
         *         "confirmed": 0,
         *         "confirms": false,
         *         "estimated": true,
         *         "total": 51908,
         *         "block_from": 1,
         *         "block": 4,
         *         "holds": 1,
         *         "hold_s": 0.1504,
         *         "line_use": 1,
         *         "plc": null,
         *         "program": "O0042",
         *         "block_text": "G55",
         *         "needs_confirmation": {
         *           "job": null,
         *           "text": "a block broke off on this line",
         *           "said": {
         *             "id": "block_torn_here",
         *             "values": {}
         *           },
         *           "reason_id": "line_torn"
         *         }
         *       }
         *     }
         */
        Machine: {
            /** @description of the machine */
            name: string;
            /** @description of its profile, from 1 */
            revision: number;
            profile: components["schemas"]["Profile"];
            status: components["schemas"]["MachineStatus"];
        };
        /**
         * @description a machine as a list shows it
         * @example {
         *       "name": "lathe-0",
         *       "revision": 1,
         *       "title": "Lathe with Fanuc 0i-TF",
         *       "dialect": "fanuc",
         *       "kind": "lathe",
         *       "link": "tcp://10.0.0.21:4001",
         *       "status": {
         *         "line": "feeding",
         *         "stall": null,
         *         "stop_wanted": false,
         *         "link_error": null,
         *         "link_error_id": null,
         *         "link_error_said": null,
         *         "link_note": null,
         *         "link_note_id": null,
         *         "line_errors": {
         *           "parity": 0,
         *           "framing": 0,
         *           "overrun": 0,
         *           "breaks": 0
         *         },
         *         "asks_since_ms": null,
         *         "asks": 0,
         *         "job": 1,
         *         "handed": 68016,
         *         "clocked": 66985,
         *         "confirmed": 0,
         *         "confirms": false,
         *         "estimated": true,
         *         "total": 78881,
         *         "block_from": 2568,
         *         "block": 2606,
         *         "holds": 0,
         *         "hold_s": 0,
         *         "line_use": 0.989,
         *         "plc": null,
         *         "program": "O0042",
         *         "block_text": "G01 X50.100 Z-129.900 F0.2",
         *         "needs_confirmation": null
         *       }
         *     }
         */
        MachineSummary: {
            /** @description of the machine */
            name: string;
            /** @description of its profile, from 1 */
            revision: number;
            /** @description for people; empty: none */
            title: string;
            /** @description of its control */
            dialect: string;
            /**
             * @description of machine
             * @enum {string}
             */
            kind: "mill" | "lathe" | "mill-turn";
            /** @description URL of its line */
            link: string;
            status: components["schemas"]["MachineStatus"];
        };
        /**
         * @description how a machine's line was used
         * @example {
         *       "days": [
         *         {
         *           "day": "2026-11-26",
         *           "from_ms": 1795651200000,
         *           "to_ms": 1795737600000,
         *           "feeding_s": 0,
         *           "held_s": 0,
         *           "jobs_done": 0,
         *           "jobs_failed": 0,
         *           "jobs_cancelled": 0,
         *           "bytes": 0
         *         },
         *         {
         *           "day": "2026-11-27",
         *           "from_ms": 1795737600000,
         *           "to_ms": 1795824000000,
         *           "feeding_s": 0,
         *           "held_s": 0,
         *           "jobs_done": 0,
         *           "jobs_failed": 0,
         *           "jobs_cancelled": 0,
         *           "bytes": 0
         *         },
         *         {
         *           "day": "2026-11-28",
         *           "from_ms": 1795824000000,
         *           "to_ms": 1795910400000,
         *           "feeding_s": 0.616,
         *           "held_s": 0,
         *           "jobs_done": 1,
         *           "jobs_failed": 0,
         *           "jobs_cancelled": 1,
         *           "bytes": 581
         *         }
         *       ]
         *     }
         */
        Utilisation: {
            /** @description oldest first */
            days: {
                /** @description as 2026-11-24 */
                day: string;
                /** @description its start; milliseconds since 1970, UTC */
                from_ms: number;
                /** @description its end; milliseconds since 1970, UTC */
                to_ms: number;
                /** @description while a job was on the line, in seconds */
                feeding_s: number;
                /** @description of it, held by the control; null: not known */
                held_s: number | null;
                /** @description that ended on this day */
                jobs_done: number;
                /** @description that ended on this day */
                jobs_failed: number;
                /** @description that ended on this day */
                jobs_cancelled: number;
                /** @description of jobs that ended on this day, in bytes on the wire */
                bytes: number;
            }[];
        };
        /**
         * @description a server that shares the store with others
         * @example {
         *       "name": "hall-1",
         *       "this": true,
         *       "url": "https://dnc-1.shop",
         *       "version": "0.1.0",
         *       "answers": true,
         *       "started_at_ms": 1795500000000,
         *       "seen_at_ms": 1795507200000,
         *       "machines": [
         *         {
         *           "name": "lathe-1",
         *           "lease": 3,
         *           "since_ms": 1795500000000,
         *           "given_by": "dripfeed",
         *           "reason": null
         *         }
         *       ]
         *     }
         */
        Node: {
            /** @description of the server */
            name: string;
            /** @description it is the one that answers */
            this: boolean;
            /** @description where people and programs reach it; null: not known yet */
            url: string | null;
            /** @description of its program */
            version: string | null;
            /** @description it was heard of within the last ten seconds */
            answers: boolean;
            /** @description when, by the database's clock; milliseconds since 1970, UTC */
            started_at_ms: number;
            /** @description when it was heard of last, by the database's clock; milliseconds since 1970, UTC */
            seen_at_ms: number;
            /** @description by name */
            machines: {
                /** @description of the machine */
                name: string;
                /** @description number of the lease: one more with each new holder */
                lease: number;
                /** @description when the server got the line; milliseconds since 1970, UTC */
                since_ms: number;
                /** @description who gave it */
                given_by: string;
                /** @description what they wrote */
                reason: string | null;
            }[];
        };
        /**
         * @description a test of a line with a loopback plug in the control's place
         * @example {
         *       "fault": null,
         *       "fault_id": null,
         *       "result": {
         *         "char_ms": 0.5208,
         *         "latency_ms": {
         *           "median": 0,
         *           "worst": 2.8967
         *         },
         *         "latency_chars": 6,
         *         "after_dc3": {
         *           "holds": 20,
         *           "median": 0,
         *           "worst": 2
         *         },
         *         "characters": 457,
         *         "wrong": 0,
         *         "uart": {
         *           "parity": 0,
         *           "framing": 0,
         *           "overrun": 0,
         *           "breaks": 0
         *         },
         *         "budget": {
         *           "overrun": 10,
         *           "unsent": 3,
         *           "latency_chars": 5
         *         },
         *         "kept": true
         *       }
         *     }
         */
        LineTest: {
            /** @description what was seen instead of a result; null: nothing */
            fault: string | null;
            /**
             * @description kind of fault; null: none
             * @enum {string|null}
             */
            fault_id: "no_characters" | "settings" | "not_open" | "lost" | "nothing_came" | "other_came" | "ended" | null;
            /** @description what was measured; null where the test has a fault */
            result: {
                /** @description time of one character on the line, in milliseconds */
                char_ms: number;
                /** @description time of a character to the plug and back, in addition to its own line time, in milliseconds */
                latency_ms: {
                    /** @description of all */
                    median: number;
                    /** @description of all */
                    worst: number;
                };
                /** @description the worst of it as characters: what the profile's latency_chars should cover */
                latency_chars: number;
                /** @description characters that still came after a DC3 */
                after_dc3: {
                    /** @description how often it was tried */
                    holds: number;
                    /** @description of all */
                    median: number;
                    /** @description of all */
                    worst: number;
                };
                /** @description that were sent */
                characters: number;
                /** @description that came back as something else */
                wrong: number;
                /** @description what the UART counted since the link is up */
                uart: {
                    /** @description characters with wrong parity */
                    parity: number;
                    /** @description characters without a stop bit */
                    framing: number;
                    /** @description characters that were lost */
                    overrun: number;
                    /** @description breaks of the line */
                    breaks: number;
                };
                /** @description by the machine's profile */
                budget: {
                    /** @description characters that the control takes after its DC3 */
                    overrun: number;
                    /** @description characters that are given to the port ahead */
                    unsent: number;
                    /** @description characters that the latency may cost */
                    latency_chars: number;
                };
                /** @description nothing came back wrong, and no more after a DC3 than the control takes */
                kept: boolean;
            } | null;
        };
        /**
         * @description what passed on a line; only in the stream of its machine's wire
         * @example {
         *       "from": 0,
         *       "lost": 0,
         *       "runs": [
         *         {
         *           "kind": "in",
         *           "at_ms": 1795879663732,
         *           "to_ms": 1795879663732,
         *           "text": "␑",
         *           "hex": "11",
         *           "wrong": 0
         *         }
         *       ]
         *     }
         */
        EventWire: {
            /** @description number of the first character or change, counted by the line */
            from: number;
            /** @description characters before it that this watcher was too slow for */
            lost: number;
            /** @description in their order */
            runs: {
                /**
                 * @description of what passed
                 * @enum {string}
                 */
                kind: "in" | "out" | "up" | "lost" | "cts_on" | "cts_off" | "dsr_on" | "dsr_off";
                /** @description its first character; milliseconds since 1970, UTC */
                at_ms: number;
                /** @description its last character; milliseconds since 1970, UTC */
                to_ms: number;
                /** @description one character each; controls as their Unicode pictures (␀ to ␡) */
                text: string;
                /** @description the bytes on the wire, two digits each */
                hex: string;
                /** @description characters with wrong parity, or that the line's code does not have */
                wrong: number;
            }[];
        };
        /**
         * @description a machine's profile or the stall of its line has changed
         * @example {
         *       "name": "lathe",
         *       "stall": "waiting for DC1"
         *     }
         */
        EventMachine: {
            /** @description of the machine */
            name: string;
            stall?: components["schemas"]["Stall"];
        };
        /**
         * @description where a machine's line stands; at most five times a second
         * @example {
         *       "machine": "lathe",
         *       "line": "torn",
         *       "stall": "peer gone",
         *       "stop_wanted": false,
         *       "link_error": "Connection reset by peer",
         *       "link_error_id": "system",
         *       "link_error_said": null,
         *       "link_note": null,
         *       "link_note_id": null,
         *       "line_errors": {
         *         "parity": 0,
         *         "framing": 0,
         *         "overrun": 0,
         *         "breaks": 0
         *       },
         *       "asks_since_ms": null,
         *       "asks": 0,
         *       "job": 1,
         *       "handed": 29,
         *       "clocked": 0,
         *       "confirmed": 0,
         *       "confirms": false,
         *       "estimated": true,
         *       "total": 3831,
         *       "block_from": 1,
         *       "block": 5,
         *       "holds": 1,
         *       "hold_s": 0.1504,
         *       "line_use": 1,
         *       "plc": null,
         *       "program": "O0042",
         *       "block_text": "T0101"
         *     }
         */
        EventProgress: {
            /** @description its name */
            machine: string;
            /**
             * @description state of the line
             * @enum {string}
             */
            line: "disconnected" | "idle" | "armed" | "feeding" | "held" | "draining" | "torn" | "receiving" | "answering";
            stall: components["schemas"]["Stall"] | null;
            /** @description a person's stop is in force, reached or not */
            stop_wanted: boolean;
            /** @description why the link is down */
            link_error: string | null;
            /** @description the same as the id of a sentence; `system`: in the system's own words */
            link_error_id: string | null;
            link_error_said: components["schemas"]["Said"] | null;
            /** @description of a link that is up: what its device server did not confirm */
            link_note: string | null;
            /** @description which kind of note it is */
            link_note_id: string | null;
            /** @description what the UART counted since the link is up */
            line_errors: {
                /** @description characters with wrong parity */
                parity: number;
                /** @description characters without a stop bit */
                framing: number;
                /** @description characters that were lost */
                overrun: number;
                /** @description breaks of the line */
                breaks: number;
            };
            /** @description since when the control asks for a program while nothing is armed; milliseconds since 1970, UTC */
            asks_since_ms: number | null;
            /** @description how often it has asked since then */
            asks: number;
            /** @description the last job that was armed here since the server's start */
            job: number | null;
            /** @description given to the system's port, in bytes on the wire */
            handed: number;
            /** @description that have left, by line time, in bytes on the wire */
            clocked: number;
            /** @description that the protocol acknowledged, in bytes on the wire */
            confirmed: number;
            /** @description the protocol acknowledges; without, `confirmed` stays 0 */
            confirms: boolean;
            /** @description a blind link: how much is in transit is an estimate */
            estimated: boolean;
            /** @description of the job, in bytes on the wire */
            total: number;
            /** @description first line of the text where the control may be; 0: not known */
            block_from: number;
            /** @description last line of the text where the control may be; 0: not known */
            block: number;
            /** @description how often the control held the line in this job */
            holds: number;
            /** @description how long it held it, in seconds */
            hold_s: number;
            /** @description share of line time used while not held, 0 to 1 */
            line_use: number;
            /** @description what the machine's PLC reports of it; null where the link has no such words */
            plc: {
                /**
                 * @description of the machine
                 * @enum {string}
                 */
                state: "unknown" | "idle" | "running" | "held" | "alarm" | "emergency stop" | "manual";
                /** @description its number; 0: none, or not known */
                program: number;
                /** @description being executed, from 1; 0: not known */
                line: number;
                /** @description the control's own number; 0: none */
                alarm: number;
            } | null;
            /** @description name of the job's program; empty: no job */
            program: string;
            /** @description the line `block` of the text; empty: not known */
            block_text: string;
        };
        /**
         * @description a part family as a list shows it
         * @example {
         *       "name": "hyperbolic-roll",
         *       "title": "Hyperbolic rolling-mill roll",
         *       "revision": 1,
         *       "changed_by": "the programmer",
         *       "changed_at_ms": 1795879506857
         *     }
         */
        FamilySummary: {
            /** @description of the family */
            name: string;
            /** @description for people; empty: none */
            title: string;
            /** @description of its text, from 1 */
            revision: number;
            /** @description who made this revision */
            changed_by: string;
            /** @description when it was made; milliseconds since 1970, UTC */
            changed_at_ms: number;
        };
        /**
         * @description a part family
         * @example {
         *       "name": "hyperbolic-roll",
         *       "title": "Hyperbolic rolling-mill roll",
         *       "revision": 1,
         *       "changed_by": "the programmer",
         *       "changed_at_ms": 1795879506857,
         *       "text": "# Finishing of a rolling-mill roll with a hyperbolic barrel, from the large end over the waist to the other end.\n# z is 0 in the middle of the roll. x = 2*half_axis_x/cos(t), z = half_axis_z*tan(t) is the hyperbola by its angle t.\nfamily hyperbolic-roll \"Hyperbolic rolling-mill roll\"\nmachine lathe, ",
         *       "parameters": [
         *         {
         *           "name": "half_axis_x",
         *           "kind": "length",
         *           "unit": "mm",
         *           "default": "100 mm",
         *           "low": 10,
         *           "high": 400,
         *           "step": 0,
         *           "choices": [],
         *           "fewest": 0,
         *           "most": 0,
         *           "text": "radius at the waist",
         *           "group": ""
         *         },
         *         {
         *           "name": "half_axis_z",
         *           "kind": "length",
         *           "unit": "mm",
         *           "default": "202.4 mm",
         *           "low": 10,
         *           "high": 800,
         *           "step": 0,
         *           "choices": [],
         *           "fewest": 0,
         *           "most": 0,
         *           "text": "half axis along z",
         *           "group": ""
         *         },
         *         {
         *           "name": "roll_length",
         *           "kind": "length",
         *           "unit": "mm",
         *           "default": "196 mm",
         *           "low": 10,
         *           "high": 1000,
         *           "step": 0,
         *           "choices": [],
         *           "fewest": 0,
         *           "most": 0,
         *           "text": "length of the barrel",
         *           "group": ""
         *         }
         *       ]
         *     }
         */
        Family: {
            /** @description of the family */
            name: string;
            /** @description for people; empty: none */
            title: string;
            /** @description of its text, from 1 */
            revision: number;
            /** @description who made this revision */
            changed_by: string;
            /** @description when it was made; milliseconds since 1970, UTC */
            changed_at_ms: number;
            /** @description in the family language */
            text: string;
            /** @description in the text's order */
            parameters: {
                /** @description of the parameter */
                name: string;
                /** @description as the family's `param` line names it: length, count, choice, yes_no, tool, text, list of length ... */
                kind: string;
                /** @description of default, low and high; empty: a plain number */
                unit: string;
                /** @description as one would write it: "100 mm" */
                default: string;
                /** @description least value, in `unit`; null: no bound */
                low: number | null;
                /** @description greatest value, in `unit`; null: no bound */
                high: number | null;
                /** @description values are `low` plus a whole number of steps, in `unit`; 0: any value */
                step: number;
                /** @description the words of a choice or of yes_no */
                choices: string[];
                /** @description numbers of a list; 0: it is none */
                fewest: number;
                /** @description numbers of a list; 0: it is none */
                most: number;
                /** @description what it is, for people */
                text: string;
                /** @description the heading under which forms show it; may be empty */
                group: string;
            }[];
        };
        /**
         * @description a family with values
         * @example {
         *       "number": "R-1",
         *       "revision": 2,
         *       "family": "hyperbolic-roll",
         *       "family_revision": 2,
         *       "values": {
         *         "angle_step": "1 deg"
         *       },
         *       "changed_by": "the programmer",
         *       "changed_at_ms": 1795879506950
         *     }
         */
        Part: {
            /** @description of the part */
            number: string;
            /** @description of its values, from 1 */
            revision: number;
            /** @description its name */
            family: string;
            /** @description against which the values hold */
            family_revision: number;
            /** @description those that are given, by parameter */
            values: {
                [key: string]: string;
            };
            /** @description who made this revision */
            changed_by: string;
            /** @description when it was made; milliseconds since 1970, UTC */
            changed_at_ms: number;
        };
        /** @description a variable, or a list of some in a row */
        LegendEntry: {
            /** @description as the control names it; of a list the first */
            variable: string;
            /** @description how many, in a row; 1: no list */
            count: number;
            /** @description in the family */
            name: string;
            /** @description of the parameter; null: none is stated */
            meaning: string | null;
            /** @description of the number in the variable; null: none, or not known */
            unit: string | null;
            /**
             * @description parameter: people may change it; derived: it follows from those; computed: the program changes it
             * @enum {string}
             */
            kind: "parameter" | "derived" | "computed";
            /** @description that the text gives it; null: a list, or computed */
            value: number | null;
        };
        /**
         * @description a program with its newest revision
         * @example {
         *       "id": 77,
         *       "name": "O0042",
         *       "dialect": "fanuc",
         *       "tags": [
         *         "hub"
         *       ],
         *       "folder": null,
         *       "archived": null,
         *       "deleted": null,
         *       "revision": 1,
         *       "sha256": "9f2c4e0b8a6d1f3579bd02468ace13579bdf02468ace13579bdf02468ace1357",
         *       "bytes": 24,
         *       "blocks": 3,
         *       "origin": {
         *         "kind": "uploaded"
         *       },
         *       "created_by": "the MES",
         *       "created_at_ms": 1795500100000
         *     }
         */
        Program: {
            /** @description of the program */
            id: number;
            /** @description of the program */
            name: string;
            /** @description of its text */
            dialect: string;
            /** @description that people gave it, sorted */
            tags: string[];
            /** @description in which people put it, as "customer/pumps"; null: in none */
            folder: string | null;
            /** @description who put it aside; null: it is in use */
            archived: {
                /** @description who did */
                by: string;
                /** @description why */
                reason: string;
                /** @description when; milliseconds since 1970, UTC */
                at_ms: number;
            } | null;
            /** @description who deleted it; null: it is not; the revision is 0 where nothing names its text */
            deleted: {
                /** @description who did */
                by: string;
                /** @description why */
                reason: string;
                /** @description when; milliseconds since 1970, UTC */
                at_ms: number;
            } | null;
            /** @description of the text, from 1 */
            revision: number;
            /** @description of the text, in hexadecimal */
            sha256: string;
            /** @description of the text */
            bytes: number;
            /** @description lines of the text that are not empty and no % */
            blocks: number;
            /** @description where the text comes from; an uploaded one has its kind alone */
            origin: {
                /**
                 * @description of origin
                 * @enum {string}
                 */
                kind: "uploaded" | "rendered";
                /** @description that was rendered */
                family?: string;
                /** @description of that family */
                family_revision?: number;
                /** @description whose values were taken; null: values of the request */
                part?: string | null;
                /** @description of that part; 0: none */
                part_revision?: number;
                /** @description for which it was rendered */
                machine?: string;
                /** @description of that machine's profile */
                machine_revision?: number;
                /**
                 * @description how it was rendered
                 * @enum {string}
                 */
                mode?: "macro" | "explicit" | "auto";
            };
            /** @description who made it */
            created_by: string;
            /** @description when it was made; milliseconds since 1970, UTC */
            created_at_ms: number;
        };
        /**
         * @description one revision of a program
         * @example {
         *       "id": 2,
         *       "revision": 2,
         *       "sha256": "f9d057e3f0ca2812ff3706a9859af1125ae513181d084c35a4c46400cb3c4933",
         *       "bytes": 51908,
         *       "blocks": 2010,
         *       "origin": {
         *         "kind": "uploaded"
         *       },
         *       "created_by": "the programmer",
         *       "created_at_ms": 1795879507303
         *     }
         */
        ProgramRevision: {
            /** @description of the program */
            id: number;
            /** @description of the text, from 1 */
            revision: number;
            /** @description of the text, in hexadecimal */
            sha256: string;
            /** @description of the text */
            bytes: number;
            /** @description lines of the text that are not empty and no % */
            blocks: number;
            /** @description where the text comes from; an uploaded one has its kind alone */
            origin: {
                /**
                 * @description of origin
                 * @enum {string}
                 */
                kind: "uploaded" | "rendered";
                /** @description that was rendered */
                family?: string;
                /** @description of that family */
                family_revision?: number;
                /** @description whose values were taken; null: values of the request */
                part?: string | null;
                /** @description of that part; 0: none */
                part_revision?: number;
                /** @description for which it was rendered */
                machine?: string;
                /** @description of that machine's profile */
                machine_revision?: number;
                /**
                 * @description how it was rendered
                 * @enum {string}
                 */
                mode?: "macro" | "explicit" | "auto";
            };
            /** @description who made it */
            created_by: string;
            /** @description when it was made; milliseconds since 1970, UTC */
            created_at_ms: number;
        };
        /**
         * @description some lines of a revision
         * @example {
         *       "from": 22,
         *       "count_all": 51,
         *       "lines": [
         *         {
         *           "line": 22,
         *           "text": "X215.458 Z81.101",
         *           "family_line": 43,
         *           "family_text": "        cut x 2*half_axis_x/cos(t)  z half_axis_z*tan(t)",
         *           "values": {
         *             "t": 21.8358
         *           }
         *         },
         *         {
         *           "line": 23,
         *           "text": "X212.615 Z73.011",
         *           "family_line": 43,
         *           "family_text": "        cut x 2*half_axis_x/cos(t)  z half_axis_z*tan(t)",
         *           "values": {
         *             "t": 19.8358
         *           }
         *         },
         *         {
         *           "line": 24,
         *           "text": "X210.098 Z65.123",
         *           "family_line": 43,
         *           "family_text": "        cut x 2*half_axis_x/cos(t)  z half_axis_z*tan(t)",
         *           "values": {
         *             "t": 17.8358
         *           }
         *         }
         *       ]
         *     }
         */
        ProgramLines: {
            /** @description the first of them, from 1 */
            from: number;
            /** @description lines of the revision */
            count_all: number;
            /** @description in their order */
            lines: {
                /** @description of the text, from 1 */
                line: number;
                /** @description its text */
                text: string;
                /** @description of the family; null: not known */
                family_line: number | null;
                /** @description that line; null: not known */
                family_text: string | null;
                /** @description variables of that line at this block; null: not known */
                values: {
                    [key: string]: number;
                } | null;
            }[];
        };
        /**
         * @description what rendering would store; nothing is stored
         * @example {
         *       "text": "%\nO0001(TURNING)\nG21 G18 G99 G40\n(HYPERBOLIC-ROLL, HYPERBOLIC ROLLING-MILL ROLL)\n(REVISION 2)\n(PART R-1 REVISION 2)\n(HALF AXIS X 100 MM)\n(HALF AXIS Z 202.4 MM)\n(ROLL LENGTH 196 MM)\n(STEPPING UNIFORM)\n(ANGLE STEP 1 DEG)\n(CHORD ERROR 0.002 MM)\n(CLEARANCE 25 MM)\n(SPEED RPM 500 RPM)\n(CUT FEED 0.15 MM/RE",
         *       "mode": "explicit",
         *       "because": "the control is fed block by block and then rejects jumps and loops",
         *       "blocks": 76,
         *       "bytes": 1314,
         *       "variables": 0,
         *       "legend": [],
         *       "diagnostics": [],
         *       "drawing": [
         *         {
         *           "axes": "zx",
         *           "lines": [
         *             {
         *               "of": "stock",
         *               "points": [
         *                 [
         *                   -98,
         *                   -113.105
         *                 ],
         *                 [
         *                   98,
         *                   -113.105
         *                 ],
         *                 [
         *                   98,
         *                   113.105
         *                 ]
         *               ]
         *             },
         *             {
         *               "of": "nominal",
         *               "points": [
         *                 [
         *                   -98,
         *                   111.105
         *                 ],
         *                 [
         *                   -97.948,
         *                   111.094
         *                 ],
         *                 [
         *                   -97.79,
         *                   111.06
         *                 ]
         *               ]
         *             },
         *             {
         *               "of": "nominal",
         *               "points": [
         *                 [
         *                   -98,
         *                   -111.105
         *                 ],
         *                 [
         *                   -97.948,
         *                   -111.094
         *                 ],
         *                 [
         *                   -97.79,
         *                   -111.06
         *                 ]
         *               ]
         *             }
         *           ],
         *           "circles": [],
         *           "dimensions": [
         *             {
         *               "parameter": "half_axis_x",
         *               "kind": "radius",
         *               "value": "100 mm",
         *               "from": [
         *                 0,
         *                 0
         *               ],
         *               "to": [
         *                 0,
         *                 100
         *               ],
         *               "at": null
         *             },
         *             {
         *               "parameter": "roll_length",
         *               "kind": "length",
         *               "value": "196 mm",
         *               "from": [
         *                 -98,
         *                 -111.105
         *               ],
         *               "to": [
         *                 98,
         *                 -111.105
         *               ],
         *               "at": null
         *             },
         *             {
         *               "parameter": "clearance",
         *               "kind": "length",
         *               "value": "25 mm",
         *               "from": [
         *                 98,
         *                 111.105
         *               ],
         *               "to": [
         *                 98,
         *                 136.105
         *               ],
         *               "at": null
         *             }
         *           ]
         *         }
         *       ]
         *     }
         */
        Preview: {
            /** @description of the program */
            text: string;
            /** @description of the part */
            drawing: {
                /** @description two letters, the first one across; zx: x is a radius */
                axes: string;
                /** @description of the part */
                lines: {
                    /**
                     * @description what it is a line of
                     * @enum {string}
                     */
                    of: "stock" | "nominal" | "outline";
                    /** @description in order */
                    points: number[][];
                }[];
                /** @description of the part */
                circles: {
                    /**
                     * @description what it is a line of
                     * @enum {string}
                     */
                    of: "stock" | "nominal" | "outline";
                    /** @description across and up */
                    center: number[];
                    /** @description mm */
                    diameter_mm: number;
                }[];
                /** @description in the order of the family's text */
                dimensions: {
                    /** @description its name */
                    parameter: string;
                    /**
                     * @description of the dimension
                     * @enum {string}
                     */
                    kind: "length" | "diameter" | "radius" | "angle";
                    /** @description with its unit */
                    value: string;
                    /** @description across and up */
                    from: number[];
                    /** @description across and up */
                    to: number[];
                    /** @description corner of an angle; else null */
                    at: number[] | null;
                }[];
            }[];
            /**
             * @description that was taken
             * @enum {string}
             */
            mode: "macro" | "explicit" | "auto";
            /** @description why this mode, as one sentence */
            because: string;
            /** @description lines of the text that are not empty and no % */
            blocks: number;
            /** @description of the text */
            bytes: number;
            /** @description different user variables that the text touches */
            variables: number;
            /** @description what the variables of a macro mean, by their numbers; empty: plain blocks */
            legend: components["schemas"]["LegendEntry"][];
            /** @description of the family's text */
            diagnostics: {
                /** @description of the kind of fault */
                id: string;
                /**
                 * @description how bad it is
                 * @enum {string}
                 */
                severity: "note" | "warning" | "error";
                /** @description the called program that it is in; null: the text itself */
                file: string | null;
                /** @description from 1 */
                line: number;
                /** @description from 1, in bytes */
                column: number;
                /** @description from 1, in characters */
                column_chars: number;
                /** @description one sentence */
                text: string;
                /** @description by which the control itself would name it */
                alarm: string | null;
            }[];
        };
        /**
         * @description a program that was rendered and stored
         * @example {
         *       "program": 1,
         *       "name": "O0100",
         *       "revision": 1,
         *       "mode": "explicit",
         *       "because": "the control is fed block by block and then rejects jumps and loops",
         *       "blocks": 76,
         *       "bytes": 1305,
         *       "variables": 0,
         *       "legend": [],
         *       "sha256": "d9a4ed95a1dfc8bc8bb4f85b99338a8b60167b15da76a43e930612a8bbc50bf2",
         *       "diagnostics": []
         *     }
         */
        Rendered: {
            /** @description its id */
            program: number;
            /** @description of the program */
            name: string;
            /** @description of its text */
            revision: number;
            /** @description of the text, in hexadecimal */
            sha256: string;
            /**
             * @description that was taken
             * @enum {string}
             */
            mode: "macro" | "explicit" | "auto";
            /** @description why this mode, as one sentence */
            because: string;
            /** @description lines of the text that are not empty and no % */
            blocks: number;
            /** @description of the text */
            bytes: number;
            /** @description different user variables that the text touches */
            variables: number;
            /** @description what the variables of a macro mean, by their numbers; empty: plain blocks */
            legend: components["schemas"]["LegendEntry"][];
            /** @description of the family's text */
            diagnostics: {
                /** @description of the kind of fault */
                id: string;
                /**
                 * @description how bad it is
                 * @enum {string}
                 */
                severity: "note" | "warning" | "error";
                /** @description the called program that it is in; null: the text itself */
                file: string | null;
                /** @description from 1 */
                line: number;
                /** @description from 1, in bytes */
                column: number;
                /** @description from 1, in characters */
                column_chars: number;
                /** @description one sentence */
                text: string;
                /** @description by which the control itself would name it */
                alarm: string | null;
            }[];
        };
        /** @description how long a program takes */
        Timing: {
            /** @description that ran */
            blocks: number;
            /** @description of the whole program */
            cycle_s: number;
            /** @description of motion alone */
            motion_s: number;
            /** @description of the control's computing alone */
            compute_s: number;
            /** @description of the line alone */
            line_s: number;
            /** @description standstills while the control waits for blocks */
            stalls: number;
            /** @description how much longer the program takes because of them */
            stall_s: number;
            /** @description of the program; 0: none */
            first_stall_line: number;
            /** @description compute_s may be as little, as far as the cost model is known */
            compute_low_s: number;
            /** @description and as much */
            compute_high_s: number;
            /**
             * @description of the cost model; calibrated: at this machine
             * @enum {string}
             */
            compute_source: "assumed" | "paper" | "calibrated";
            /** @description of the cost model, in words */
            compute_origin: string;
            /** @description all standstills together */
            standstill_s: number;
            /** @description since the start */
            first_stall_at_s: number;
            /** @description of all */
            longest_standstill_s: number;
            /** @description of the program; 0: none */
            longest_standstill_line: number;
            /** @description since the start */
            first_move_s: number;
            /** @description of rapid motion */
            rapid_s: number;
            /** @description of all motion */
            path_mm: number;
            /** @description on average */
            blocks_per_s: number;
            /** @description how long each was what the machine waited for, in seconds */
            limited_s: {
                /** @description in seconds */
                motion: number;
                /** @description in seconds */
                compute: number;
                /** @description in seconds */
                line: number;
                /** @description in seconds */
                buffer: number;
            };
            /** @description the times are those of the whole program, not of its beginning */
            whole: boolean;
            /** @description some lines in their order; empty where lines run more than once */
            course: number[][];
            /** @description the first ones, in their order */
            stretches: {
                /**
                 * @description what they wait for
                 * @enum {string}
                 */
                limited_by: "motion" | "compute" | "line" | "buffer";
                /** @description of the program */
                first_line: number;
                /** @description of the program */
                last_line: number;
                /** @description since the start */
                start_s: number;
                /** @description of all of them */
                duration_s: number;
            }[];
            /** @description how many there are in all */
            stretch_count: number;
            /** @description in the control; null: it is not fed over a line */
            lowest_buffer_bytes: number | null;
            /** @description in the control; null: it is not fed over a line */
            lowest_buffer_blocks: number | null;
            /** @description what would let the program run without a standstill; null: not needed, or nothing would */
            without_stall: {
                /** @description of the programmed feed, 0 to 1 */
                feed_share: number | null;
                /** @description the highest programmed feed */
                feed_mm_min: number | null;
                /** @description of the line */
                baud: number | null;
                /** @description the next usual one */
                standard_baud: number | null;
            };
        };
        /** @description how far a program lies from its nominal */
        Accuracy: {
            /** @description that were measured */
            blocks: number;
            /** @description places that were measured */
            points: number;
            /** @description size of the largest deviation */
            max_mm: number;
            /** @description of the program; 0: none */
            max_at_line: number;
            /** @description of the size, along the path */
            mean_mm: number;
            /** @description root of the mean square */
            rmse_mm: number;
            /** @description proved from the curve; null: none */
            chord_bound_mm: number | null;
            /**
             * @description of what the figures above are
             * @enum {string}
             */
            measured: "surface" | "path";
            /** @description of the programmed path */
            path: {
                /** @description places that were measured */
                points: number;
                /** @description largest deviation; positive: material is left, negative: too much is taken */
                max_mm: number;
                /** @description of the program; 0: none */
                max_at_line: number;
                /** @description where; turning: Z and radius, milling: X and Y */
                max_at: number[];
                /** @description of the size, along the path */
                mean_mm: number;
                /** @description root of the mean square */
                rmse_mm: number;
            };
            /** @description of what the tool leaves; null: the tool is not known */
            surface: {
                /** @description places that were measured */
                points: number;
                /** @description largest deviation; positive: material is left, negative: too much is taken */
                max_mm: number;
                /** @description of the program; 0: none */
                max_at_line: number;
                /** @description where; turning: Z and radius, milling: X and Y */
                max_at: number[];
                /** @description of the size, along the path */
                mean_mm: number;
                /** @description root of the mean square */
                rmse_mm: number;
            } | null;
            /** @description farthest reach of the path beyond the ends of the nominal */
            overrun_mm: number;
            /** @description the path passes all of the nominal */
            covered: boolean;
            /** @description the first ones of each kind */
            findings: {
                /** @description of the kind of finding */
                id: string;
                /**
                 * @description how bad it is
                 * @enum {string}
                 */
                severity: "note" | "warning" | "error";
                /** @description of the program, from 1; 0: of the whole */
                line: number;
                /** @description index into `programs`; 0: the main one */
                program: number;
                /** @description that was found */
                value: number | null;
                /** @description that it breaks */
                limit: number | null;
                /** @description one sentence */
                text: string;
                /** @description by which the control itself would name it */
                alarm: string | null;
            }[];
            /** @description all findings, by their id */
            counts: {
                [key: string]: number;
            };
        };
        /** @description whether a program stays inside the machine */
        Envelope: {
            /** @description the first ones of each kind */
            findings: {
                /** @description of the kind of finding */
                id: string;
                /**
                 * @description how bad it is
                 * @enum {string}
                 */
                severity: "note" | "warning" | "error";
                /** @description of the program, from 1; 0: of the whole */
                line: number;
                /** @description index into `programs`; 0: the main one */
                program: number;
                /** @description that was found */
                value: number | null;
                /** @description that it breaks */
                limit: number | null;
                /** @description one sentence */
                text: string;
                /** @description by which the control itself would name it */
                alarm: string | null;
            }[];
            /** @description all findings, by their id */
            counts: {
                [key: string]: number;
            };
            /** @description that were checked */
            moves: number;
            /** @description reached in machine coordinates, in millimeters or degrees, by axis */
            machine_travel: {
                [key: string]: (number | null)[];
            };
            /** @description the highest */
            feed_max_mm_min: number;
            /** @description the highest */
            spindle_max_rpm: number;
        };
        /** @description whether a program cuts where it must not */
        Gouge: {
            /** @description the first ones of each kind */
            findings: {
                /** @description of the kind of finding */
                id: string;
                /**
                 * @description how bad it is
                 * @enum {string}
                 */
                severity: "note" | "warning" | "error";
                /** @description of the program, from 1; 0: of the whole */
                line: number;
                /** @description index into `programs`; 0: the main one */
                program: number;
                /** @description that was found */
                value: number | null;
                /** @description that it breaks */
                limit: number | null;
                /** @description one sentence */
                text: string;
                /** @description by which the control itself would name it */
                alarm: string | null;
            }[];
            /** @description all findings, by their id */
            counts: {
                [key: string]: number;
            };
            /** @description that were checked */
            rapids: number;
            /** @description that were checked */
            cuts: number;
            /** @description into stock or part */
            deepest_rapid_mm: number;
            /** @description below the nominal */
            deepest_cut_mm: number;
        };
        /**
         * @description what the checks found in a program, without their report
         * @example {
         *       "id": 140,
         *       "program": 77,
         *       "revision": 1,
         *       "sha256": "9f2c4e0b8a6d1f3579bd02468ace13579bdf02468ace13579bdf02468ace1357",
         *       "machine": "lathe-1",
         *       "machine_revision": 4,
         *       "delivery": "drip",
         *       "verdict": "pass",
         *       "rules": "2f0d3a91c4be7765",
         *       "stale": false,
         *       "created_by": "the MES",
         *       "created_at_ms": 1795500200000,
         *       "calls": [],
         *       "points": [],
         *       "waivers": []
         *     }
         */
        VerdictSummary: {
            /** @description of the verdict */
            id: number;
            /** @description its id */
            program: number;
            /** @description of the program's text */
            revision: number;
            /** @description of the text, in hexadecimal */
            sha256: string;
            /** @description for which it was checked */
            machine: string;
            /** @description of that machine's profile */
            machine_revision: number;
            /**
             * @description for which it was checked
             * @enum {string}
             */
            delivery: "drip" | "memory";
            /**
             * @description pass needs everything that moves, shifts or writes to be understood
             * @enum {string}
             */
            verdict: "pass" | "warn" | "fail" | "unknown";
            /** @description the revision of the code that judged; null: an older server did */
            rules: string | null;
            /** @description the machine's profile, the family, a called program or the code that judges has changed since */
            stale: boolean;
            /** @description who made it */
            created_by: string;
            /** @description when it was made; milliseconds since 1970, UTC */
            created_at_ms: number;
            /** @description called programs; the verdict holds while these revisions are the ones that are called */
            calls: {
                /** @description by which it is called */
                name: string;
                /** @description id of the program */
                program: number;
                /** @description of the program */
                revision: number;
            }[];
            /** @description what stands between it and a pass; none: it is waived as a whole, or not at all */
            points: string[];
            /** @description of this verdict */
            waivers: {
                /** @description of the person */
                name: string;
                /** @description why */
                reason: string;
                /** @description when; milliseconds since 1970, UTC */
                at_ms: number;
                /** @description that it is for; null: for all of them */
                point: string | null;
                /** @description from then on it no longer counts; null: it does not end; milliseconds since 1970, UTC */
                expires_at_ms: number | null;
            }[];
        };
        /**
         * @description what a check of a rendered program would find; it is stored nowhere, and releases nothing
         * @example {
         *       "verdict": "pass",
         *       "points": [],
         *       "dialect": "fanuc",
         *       "control": {
         *         "title": "Fanuc 0i-TF",
         *         "kind": "lathe",
         *         "g_system": "A",
         *         "feed_mode": "per-revolution",
         *         "because_line": 0,
         *         "inferred": false
         *       },
         *       "diagnostics": [],
         *       "folded": [],
         *       "blocks": 63,
         *       "ran": true,
         *       "timing": {
         *         "blocks": 63,
         *         "cycle_s": 162.4901,
         *         "motion_s": 162.3183,
         *         "compute_s": 0.126,
         *         "line_s": 0.7009,
         *         "stalls": 0,
         *         "stall_s": 0,
         *         "first_stall_line": 0,
         *         "compute_low_s": 0.0252,
         *         "compute_high_s": 0.63,
         *         "compute_source": "assumed",
         *         "compute_origin": "0i class",
         *         "standstill_s": 0,
         *         "first_stall_at_s": 0,
         *         "longest_standstill_s": 0,
         *         "longest_standstill_line": 0,
         *         "first_move_s": 0.1718,
         *         "rapid_s": 1.1125,
         *         "path_mm": 479.6022,
         *         "blocks_per_s": 0.3877,
         *         "limited_s": {
         *           "motion": 162.3183,
         *           "compute": 0,
         *           "line": 0,
         *           "buffer": 0
         *         },
         *         "whole": true,
         *         "course": [
         *           [
         *             16,
         *             0.1698
         *           ],
         *           [
         *             17,
         *             0.1718
         *           ],
         *           [
         *             18,
         *             1.6718
         *           ]
         *         ],
         *         "stretches": [
         *           {
         *             "limited_by": "motion",
         *             "first_line": 16,
         *             "last_line": 77,
         *             "start_s": 0.1698,
         *             "duration_s": 162.3183
         *           }
         *         ],
         *         "stretch_count": 1,
         *         "lowest_buffer_bytes": 0,
         *         "lowest_buffer_blocks": 0,
         *         "without_stall": {
         *           "feed_share": null,
         *           "feed_mm_min": null,
         *           "baud": null,
         *           "standard_baud": null
         *         }
         *       },
         *       "accuracy": {
         *         "blocks": 53,
         *         "points": 329,
         *         "max_mm": 0.0042,
         *         "max_at_line": 22,
         *         "mean_mm": 0.0026,
         *         "rmse_mm": 0.0029,
         *         "chord_bound_mm": 0.0043,
         *         "measured": "surface",
         *         "path": {
         *           "points": 329,
         *           "max_mm": 0.0042,
         *           "max_at_line": 22,
         *           "max_at": [
         *             95.8395,
         *             110.6487
         *           ],
         *           "mean_mm": 0.0026,
         *           "rmse_mm": 0.0029
         *         },
         *         "surface": {
         *           "points": 329,
         *           "max_mm": 0.0042,
         *           "max_at_line": 22,
         *           "max_at": [
         *             95.8395,
         *             110.6487
         *           ],
         *           "mean_mm": 0.0026,
         *           "rmse_mm": 0.0029
         *         },
         *         "overrun_mm": 1.9552,
         *         "covered": true,
         *         "findings": [],
         *         "counts": {}
         *       },
         *       "envelope": {
         *         "findings": [],
         *         "counts": {},
         *         "moves": 57,
         *         "machine_travel": {
         *           "X": [
         *             100.0005,
         *             136.1055
         *           ],
         *           "Z": [
         *             -498,
         *             -277
         *           ]
         *         },
         *         "feed_max_mm_min": 75,
         *         "spindle_max_rpm": 500
         *       },
         *       "gouge": {
         *         "findings": [],
         *         "counts": {},
         *         "rapids": 4,
         *         "cuts": 53,
         *         "deepest_rapid_mm": 0,
         *         "deepest_cut_mm": 0.0003
         *       },
         *       "not_checked": [
         *         "with tool radius compensation the travel is that of the programmed path (line 21)",
         *         "a move starts at a position that is not known: its end alone was checked (line 19)",
         *         "a move starts at a position that is not known: its length is not counted (line 19)"
         *       ],
         *       "programs": [
         *         "O0001"
         *       ]
         *     }
         */
        PreviewVerdict: {
            /**
             * @description pass needs everything that moves, shifts or writes to be understood
             * @enum {string}
             */
            verdict: "pass" | "warn" | "fail" | "unknown";
            /** @description what stands between it and a pass */
            points: string[];
            /** @description in which the text was read */
            dialect: string;
            /** @description as which control the text was read */
            control: {
                /** @description for people */
                title: string;
                /**
                 * @description of machine
                 * @enum {string}
                 */
                kind: "mill" | "lathe" | "mill-turn";
                /**
                 * @description G code system of a lathe
                 * @enum {string}
                 */
                g_system: "A" | "B" | "C";
                /**
                 * @description at power-on
                 * @enum {string}
                 */
                feed_mode: "per-minute" | "per-revolution" | "inverse-time";
                /** @description by which it was inferred; 0: it was named, or is the default */
                because_line: number;
                /** @description the control was inferred from the text */
                inferred: boolean;
            };
            /** @description of reading, validating and running the text; the first of each kind */
            diagnostics: {
                /** @description of the kind of fault */
                id: string;
                /**
                 * @description how bad it is
                 * @enum {string}
                 */
                severity: "note" | "warning" | "error";
                /** @description the called program that it is in; null: the text itself */
                file: string | null;
                /** @description from 1 */
                line: number;
                /** @description from 1, in bytes */
                column: number;
                /** @description from 1, in characters */
                column_chars: number;
                /** @description one sentence */
                text: string;
                /** @description by which the control itself would name it */
                alarm: string | null;
            }[];
            /** @description of the diagnostics */
            folded: {
                /** @description of the kind of fault */
                id: string;
                /**
                 * @description how bad it is
                 * @enum {string}
                 */
                severity: "note" | "warning" | "error";
                /** @description that are not listed */
                more: number;
            }[];
            /** @description that ran */
            blocks: number;
            /** @description it ran to its end */
            ran: boolean;
            timing: components["schemas"]["Timing"] | null;
            accuracy: components["schemas"]["Accuracy"] | null;
            envelope: components["schemas"]["Envelope"] | null;
            gouge: components["schemas"]["Gouge"] | null;
            /** @description what was not checked, and why */
            not_checked: string[];
            /** @description the main one first, then those that it calls */
            programs: string[];
        };
        /**
         * @description what the checks found in a program
         * @example {
         *       "id": 1,
         *       "program": 4,
         *       "revision": 1,
         *       "sha256": "74b2997644c255a0cee818b1c9272ca503b3fad32297b9f18dc09ce4884d03a0",
         *       "machine": "turning",
         *       "machine_revision": 1,
         *       "delivery": "drip",
         *       "verdict": "pass",
         *       "rules": "291e0de94dd6f99e",
         *       "stale": false,
         *       "created_by": "admin",
         *       "created_at_ms": 1795880032131,
         *       "dialect": "fanuc",
         *       "control": {
         *         "title": "Fanuc 0i-TF",
         *         "kind": "lathe",
         *         "g_system": "A",
         *         "feed_mode": "per-revolution",
         *         "because_line": 0,
         *         "inferred": false
         *       },
         *       "diagnostics": [],
         *       "folded": [],
         *       "blocks": 37,
         *       "ran": true,
         *       "timing": {
         *         "blocks": 37,
         *         "cycle_s": 162.4771,
         *         "motion_s": 162.317,
         *         "compute_s": 0.074,
         *         "line_s": 0.4496,
         *         "stalls": 0,
         *         "stall_s": 0,
         *         "first_stall_line": 0,
         *         "compute_low_s": 0.0148,
         *         "compute_high_s": 0.37,
         *         "compute_source": "assumed",
         *         "compute_origin": "0i class",
         *         "standstill_s": 0,
         *         "first_stall_at_s": 0,
         *         "longest_standstill_s": 0,
         *         "longest_standstill_line": 0,
         *         "first_move_s": 0.1601,
         *         "rapid_s": 1.1125,
         *         "path_mm": 479.6006,
         *         "blocks_per_s": 0.2277,
         *         "limited_s": {
         *           "motion": 162.317,
         *           "compute": 0,
         *           "line": 0,
         *           "buffer": 0
         *         },
         *         "whole": true,
         *         "course": [
         *           [
         *             15,
         *             0.1581
         *           ],
         *           [
         *             16,
         *             0.1601
         *           ],
         *           [
         *             17,
         *             1.6601
         *           ]
         *         ],
         *         "stretches": [
         *           {
         *             "limited_by": "motion",
         *             "first_line": 15,
         *             "last_line": 50,
         *             "start_s": 0.1581,
         *             "duration_s": 162.317
         *           }
         *         ],
         *         "stretch_count": 1,
         *         "lowest_buffer_bytes": 0,
         *         "lowest_buffer_blocks": 0,
         *         "without_stall": {
         *           "feed_share": null,
         *           "feed_mm_min": null,
         *           "baud": null,
         *           "standard_baud": null
         *         }
         *       },
         *       "accuracy": {
         *         "blocks": 27,
         *         "points": 290,
         *         "max_mm": 0.0165,
         *         "max_at_line": 21,
         *         "mean_mm": 0.0105,
         *         "rmse_mm": 0.0114,
         *         "chord_bound_mm": 0.0167,
         *         "measured": "surface",
         *         "path": {
         *           "points": 290,
         *           "max_mm": 0.0165,
         *           "max_at_line": 21,
         *           "max_at": [
         *             93.703,
         *             110.2135
         *           ],
         *           "mean_mm": 0.0105,
         *           "rmse_mm": 0.0114
         *         },
         *         "surface": {
         *           "points": 290,
         *           "max_mm": 0.0165,
         *           "max_at_line": 21,
         *           "max_at": [
         *             93.703,
         *             110.2135
         *           ],
         *           "mean_mm": 0.0105,
         *           "rmse_mm": 0.0114
         *         },
         *         "overrun_mm": 1.9552,
         *         "covered": true,
         *         "findings": [],
         *         "counts": {}
         *       },
         *       "envelope": {
         *         "findings": [],
         *         "counts": {},
         *         "moves": 31,
         *         "machine_travel": {
         *           "X": [
         *             100.0005,
         *             136.1055
         *           ],
         *           "Z": [
         *             -498,
         *             -277
         *           ]
         *         },
         *         "feed_max_mm_min": 75,
         *         "spindle_max_rpm": 500
         *       },
         *       "gouge": {
         *         "findings": [],
         *         "counts": {},
         *         "rapids": 4,
         *         "cuts": 27,
         *         "deepest_rapid_mm": 0,
         *         "deepest_cut_mm": 0.0003
         *       },
         *       "not_checked": [
         *         "with tool radius compensation the travel is that of the programmed path (line 20)",
         *         "a move starts at a position that is not known: its end alone was checked (line 18)",
         *         "a move starts at a position that is not known: its length is not counted (line 18)"
         *       ],
         *       "programs": [
         *         "O0001"
         *       ],
         *       "calls": [],
         *       "points": [],
         *       "waivers": []
         *     }
         */
        Verdict: {
            /** @description of the verdict */
            id: number;
            /** @description its id */
            program: number;
            /** @description of the program's text */
            revision: number;
            /** @description of the text, in hexadecimal */
            sha256: string;
            /** @description for which it was checked */
            machine: string;
            /** @description of that machine's profile */
            machine_revision: number;
            /**
             * @description for which it was checked
             * @enum {string}
             */
            delivery: "drip" | "memory";
            /**
             * @description pass needs everything that moves, shifts or writes to be understood
             * @enum {string}
             */
            verdict: "pass" | "warn" | "fail" | "unknown";
            /** @description the revision of the code that judged; null: an older server did */
            rules: string | null;
            /** @description the machine's profile, the family, a called program or the code that judges has changed since */
            stale: boolean;
            /** @description who made it */
            created_by: string;
            /** @description when it was made; milliseconds since 1970, UTC */
            created_at_ms: number;
            /** @description in which the text was read */
            dialect: string;
            /** @description as which control the text was read */
            control: {
                /** @description for people */
                title: string;
                /**
                 * @description of machine
                 * @enum {string}
                 */
                kind: "mill" | "lathe" | "mill-turn";
                /**
                 * @description G code system of a lathe
                 * @enum {string}
                 */
                g_system: "A" | "B" | "C";
                /**
                 * @description at power-on
                 * @enum {string}
                 */
                feed_mode: "per-minute" | "per-revolution" | "inverse-time";
                /** @description by which it was inferred; 0: it was named, or is the default */
                because_line: number;
                /** @description the control was inferred from the text */
                inferred: boolean;
            };
            /** @description of reading, validating and running the text; the first of each kind */
            diagnostics: {
                /** @description of the kind of fault */
                id: string;
                /**
                 * @description how bad it is
                 * @enum {string}
                 */
                severity: "note" | "warning" | "error";
                /** @description the called program that it is in; null: the text itself */
                file: string | null;
                /** @description from 1 */
                line: number;
                /** @description from 1, in bytes */
                column: number;
                /** @description from 1, in characters */
                column_chars: number;
                /** @description one sentence */
                text: string;
                /** @description by which the control itself would name it */
                alarm: string | null;
            }[];
            /** @description of the diagnostics */
            folded: {
                /** @description of the kind of fault */
                id: string;
                /**
                 * @description how bad it is
                 * @enum {string}
                 */
                severity: "note" | "warning" | "error";
                /** @description that are not listed */
                more: number;
            }[];
            /** @description that ran */
            blocks: number;
            /** @description it ran to its end */
            ran: boolean;
            timing: components["schemas"]["Timing"] | null;
            accuracy: components["schemas"]["Accuracy"] | null;
            envelope: components["schemas"]["Envelope"] | null;
            gouge: components["schemas"]["Gouge"] | null;
            /** @description what was not checked, and why */
            not_checked: string[];
            /** @description the main one first, then those that it calls */
            programs: string[];
            /** @description called programs; the verdict holds while these revisions are the ones that are called */
            calls: {
                /** @description by which it is called */
                name: string;
                /** @description id of the program */
                program: number;
                /** @description of the program */
                revision: number;
            }[];
            /** @description what stands between it and a pass; none: it is waived as a whole, or not at all */
            points: string[];
            /** @description of this verdict */
            waivers: {
                /** @description of the person */
                name: string;
                /** @description why */
                reason: string;
                /** @description when; milliseconds since 1970, UTC */
                at_ms: number;
                /** @description that it is for; null: for all of them */
                point: string | null;
                /** @description from then on it no longer counts; null: it does not end; milliseconds since 1970, UTC */
                expires_at_ms: number | null;
            }[];
        };
        /**
         * @description a program was checked
         * @example {
         *       "id": 2,
         *       "verdict": "pass",
         *       "machine": "lathe",
         *       "text": "O0042"
         *     }
         */
        EventVerdict: {
            /** @description of the verdict */
            id: number;
            /**
             * @description of the checks
             * @enum {string}
             */
            verdict: "pass" | "warn" | "fail" | "unknown";
            /** @description for which it was checked */
            machine: string;
            /** @description one sentence */
            text: string;
        };
        /**
         * @description two revisions, compared
         * @example {
         *       "first": {
         *         "program": 1,
         *         "name": "O0100",
         *         "revision": 3
         *       },
         *       "second": {
         *         "program": 1,
         *         "name": "O0100",
         *         "revision": 1
         *       },
         *       "text": {
         *         "answer": "differs",
         *         "why": null,
         *         "changes": [
         *           {
         *             "first": [
         *               {
         *                 "line": 6,
         *                 "text": "N30 X20.25"
         *               }
         *             ],
         *             "second": [
         *               {
         *                 "line": 6,
         *                 "text": "N30 X20."
         *               }
         *             ]
         *           }
         *         ],
         *         "change_count": 1
         *       },
         *       "meaning": {
         *         "answer": "differs",
         *         "why": null,
         *         "changes": [
         *           {
         *             "first": [
         *               {
         *                 "line": 6,
         *                 "text": "N30 X20.25"
         *               }
         *             ],
         *             "second": [
         *               {
         *                 "line": 6,
         *                 "text": "N30 X20."
         *               }
         *             ]
         *           }
         *         ],
         *         "change_count": 1
         *       },
         *       "motions": {
         *         "answer": "differs",
         *         "why": null,
         *         "moves": 2,
         *         "first_line": 6,
         *         "second_line": 6,
         *         "first": "line X20.25 F100",
         *         "second": "line X20. F100",
         *         "deviation_mm": 0.25,
         *         "deviation_deg": 0
         *       }
         *     }
         */
        Comparison: {
            /** @description of the path */
            first: {
                /** @description its id */
                program: number;
                /** @description of the program */
                name: string;
                /** @description of its text; null: a text that was given */
                revision: number | null;
            };
            /** @description of `with` */
            second: {
                /** @description its id */
                program: number;
                /** @description of the program */
                name: string;
                /** @description of its text; null: a text that was given */
                revision: number | null;
            };
            /** @description line by line; forms of the end of a block, blank lines and blanks at the end of a line do not count */
            text: {
                /**
                 * @description the result
                 * @enum {string}
                 */
                answer: "equal" | "differs" | "not_compared";
                /** @description it was not compared; null: it was */
                why: string | null;
                /** @description in their order, 200 at most of 50 lines each */
                changes: {
                    /** @description of the first program; none: it has none there */
                    first: {
                        /** @description of that text, from 1 */
                        line: number;
                        /** @description its text */
                        text: string;
                    }[];
                    /** @description of the second */
                    second: {
                        /** @description of that text, from 1 */
                        line: number;
                        /** @description its text */
                        text: string;
                    }[];
                }[];
                /** @description all changes, shown or not */
                change_count: number;
            };
            /** @description as the dialect's reader understands it: block numbers, blanks, comments, the case of letters, leading zeros and forms of decimals do not count */
            meaning: {
                /**
                 * @description the result
                 * @enum {string}
                 */
                answer: "equal" | "differs" | "not_compared";
                /** @description it was not compared; null: it was */
                why: string | null;
                /** @description in their order, 200 at most of 50 lines each */
                changes: {
                    /** @description of the first program; none: it has none there */
                    first: {
                        /** @description of that text, from 1 */
                        line: number;
                        /** @description its text */
                        text: string;
                    }[];
                    /** @description of the second */
                    second: {
                        /** @description of that text, from 1 */
                        line: number;
                        /** @description its text */
                        text: string;
                    }[];
                }[];
                /** @description all changes, shown or not */
                change_count: number;
            };
            /** @description whether both move the axes the same, in order, with the same feeds, tools and states */
            motions: {
                /**
                 * @description the result
                 * @enum {string}
                 */
                answer: "equal" | "differs" | "not_compared";
                /** @description it was not compared; null: it was */
                why: string | null;
                /** @description that are the same, up to the first difference */
                moves: number;
                /** @description of the first difference in the first program; null: none, or it has ended */
                first_line: number | null;
                /** @description of the first difference in the second program */
                second_line: number | null;
                /** @description what the first program does there */
                first: string | null;
                /** @description what the second program does there */
                second: string | null;
                /** @description largest difference of end points and arc centres, of diameters half of it; null: not compared, or they do not consist of the same moves */
                deviation_mm: number | null;
                /** @description the same of rotary axes */
                deviation_deg: number | null;
            };
        };
        /**
         * @description programs by words, a page of them
         * @example {
         *       "items": [
         *         {
         *           "is_similar": false,
         *           "snippet": [
         *             {
         *               "text": "O0042",
         *               "is_hit": true
         *             }
         *           ],
         *           "program": {
         *             "id": 2,
         *             "name": "O0042",
         *             "dialect": "fanuc",
         *             "tags": [
         *               "pump"
         *             ],
         *             "folder": "acme",
         *             "archived": null,
         *             "deleted": null,
         *             "revision": 2,
         *             "sha256": "f9d057e3f0ca2812ff3706a9859af1125ae513181d084c35a4c46400cb3c4933",
         *             "bytes": 51908,
         *             "blocks": 2010,
         *             "origin": {
         *               "kind": "uploaded"
         *             },
         *             "created_by": "the programmer",
         *             "created_at_ms": 1795879507303
         *           }
         *         }
         *       ],
         *       "next": null,
         *       "programs": 2,
         *       "waiting": 0,
         *       "cut": 0
         *     }
         */
        SearchResult: {
            /** @description best first */
            items: {
                /** @description its name is nearly what was looked for; otherwise all words were found in it */
                is_similar: boolean;
                /** @description one after the other: the place where most of it stands */
                snippet: {
                    /** @description of what was found */
                    text: string;
                    /** @description it was looked for */
                    is_hit: boolean;
                }[];
                program: components["schemas"]["Program"];
            }[];
            /** @description for `after` of the next page; null: the last */
            next: string | null;
            /** @description that are looked through */
            programs: number;
            /** @description changes of programs that are not in the library yet */
            waiting: number;
            /** @description programs so long that not all of their moves are looked through */
            cut: number;
        };
        /**
         * @description where a program is used
         * @example {
         *       "parts": [],
         *       "machines": [],
         *       "releases": [],
         *       "has_more_releases": false,
         *       "jobs": [],
         *       "has_more_jobs": false,
         *       "called_by": [],
         *       "calls": [],
         *       "computed_calls": 0,
         *       "calls_not_known": null,
         *       "waiting": 2,
         *       "unread": 0
         *     }
         */
        ProgramUses: {
            /** @description newest first */
            parts: {
                /** @description of the part */
                number: string;
                /** @description of the part's values */
                part_revision: number;
                /** @description of the program's text */
                revision: number;
            }[];
            /** @description by name */
            machines: {
                /** @description its name */
                machine: string;
                /** @description in this answer */
                releases: number;
                /** @description in this answer */
                jobs: number;
            }[];
            /** @description newest first, 100 at most */
            releases: components["schemas"]["Release"][];
            /** @description there are older ones */
            has_more_releases: boolean;
            /** @description newest first, 100 at most */
            jobs: components["schemas"]["Job"][];
            /** @description there are older ones */
            has_more_jobs: boolean;
            /** @description 100 at most */
            called_by: {
                /** @description its id */
                program: number;
                /** @description of the program */
                name: string;
                /** @description it was put aside */
                is_archived: boolean;
                /** @description the name that the call has for it */
                called: string;
                /**
                 * @description of call
                 * @enum {string}
                 */
                kind: "subprogram" | "macro" | "external";
                /** @description of the first such call in the text that calls */
                line: number;
            }[];
            /** @description in the order of the text, 100 at most */
            calls: {
                /** @description the name that the call has for it */
                called: string;
                /**
                 * @description of call
                 * @enum {string}
                 */
                kind: "subprogram" | "macro" | "external";
                /** @description of the first such call in the text that calls */
                line: number;
                /** @description none: it is not stored here */
                programs: {
                    /** @description its id */
                    program: number;
                    /** @description of the program */
                    name: string;
                    /** @description it was put aside */
                    is_archived: boolean;
                }[];
            }[];
            /** @description calls in it that name their program by a value */
            computed_calls: number;
            /** @description why its calls are not all of them; null: they are */
            calls_not_known: string | null;
            /** @description changes of programs that are not in the library yet */
            waiting: number;
            /** @description programs that could not be read as a whole: what they call is not known */
            unread: number;
        };
        /**
         * @description what became of a file
         * @example {
         *       "added": 1,
         *       "revised": 0,
         *       "same": 0,
         *       "skipped": 0,
         *       "failed": 0,
         *       "only_looked": false,
         *       "items": [
         *         {
         *           "file": "O7.nc",
         *           "kind": "program",
         *           "outcome": "added",
         *           "why": null,
         *           "why_said": null,
         *           "name": "O7",
         *           "folder": null,
         *           "dialect": "fanuc",
         *           "program": 4,
         *           "revision": 1,
         *           "bytes": 11,
         *           "sha256": "d1d47ca349a4552de786b6b202bc58d2a08ecc87b8bd3443b4e341a29c40400f"
         *         }
         *       ]
         *     }
         */
        ImportReport: {
            /** @description programs that are new */
            added: number;
            /** @description programs that got a revision */
            revised: number;
            /** @description programs that were there with this text */
            same: number;
            /** @description programs or files that were left alone */
            skipped: number;
            /** @description programs that could not be stored */
            failed: number;
            /** @description nothing was stored: this is what an import would give */
            only_looked: boolean;
            /** @description in the order of the file */
            items: {
                /** @description its path as given */
                file: string;
                /**
                 * @description of thing
                 * @enum {string}
                 */
                kind: "program" | "family" | "part" | "machine" | "attachment" | "file";
                /**
                 * @description what became of it
                 * @enum {string}
                 */
                outcome: "added" | "revised" | "same" | "skipped" | "failed";
                /** @description it was skipped or failed; null: it was not */
                why: string | null;
                why_said: components["schemas"]["Said"] | null;
                /** @description of the program */
                name: string | null;
                /** @description of the library; null: none */
                folder: string | null;
                /** @description of the program */
                dialect: string | null;
                /** @description its id; null: none was stored */
                program: number | null;
                /** @description that has the text; null: none */
                revision: number | null;
                /** @description of the text */
                bytes: number;
                /** @description of the text */
                sha256: string | null;
            }[];
        };
        /**
         * @description a file of a program, family, part or order
         * @example {
         *       "id": 1,
         *       "program": 2,
         *       "family": null,
         *       "part": null,
         *       "order": null,
         *       "name": "sheet.pdf",
         *       "media_type": "application/octet-stream",
         *       "bytes": 8,
         *       "sha256": "e16fa5d9b51928755db85b917f0297babaf22c7a47e97d9212adab56e61ba04e",
         *       "added_by": "the programmer",
         *       "added_at_ms": 1795879507371,
         *       "removed": {
         *         "by": "the programmer",
         *         "reason": "of another part",
         *         "at_ms": 1795879507474
         *       }
         *     }
         */
        Attachment: {
            /** @description of the attachment */
            id: number;
            /** @description whose file it is, by its id; null: not of a program */
            program: number | null;
            /** @description whose file it is, by its name; null: not of a family */
            family: string | null;
            /** @description whose file it is, by its number; null: not of a part */
            part: string | null;
            /** @description whose file it is, by its id; null: not of an order */
            order: number | null;
            /** @description of the file */
            name: string;
            /** @description as whoever attached it stated it */
            media_type: string;
            /** @description of the file */
            bytes: number;
            /** @description of the file, in hexadecimal */
            sha256: string;
            /** @description who attached it */
            added_by: string;
            /** @description when; milliseconds since 1970, UTC */
            added_at_ms: number;
            /** @description who removed it; null: it is there */
            removed: {
                /** @description who did */
                by: string;
                /** @description why */
                reason: string;
                /** @description when; milliseconds since 1970, UTC */
                at_ms: number;
            } | null;
        };
        /**
         * @description what reading and validating a text finds; it is not run
         * @example {
         *       "dialect": "fanuc",
         *       "control": {
         *         "title": "Fanuc 0i-MF",
         *         "kind": "mill",
         *         "g_system": "A",
         *         "feed_mode": "per-minute",
         *         "because_line": 4,
         *         "inferred": true
         *       },
         *       "faults": [
         *         {
         *           "id": "invalid-character",
         *           "severity": "warning",
         *           "line": 7,
         *           "column_chars": 7,
         *           "end_line": 7,
         *           "end_column_chars": 8,
         *           "text": "the character n is not one that the control reads",
         *           "help": "Controls read ASCII only. Remove the character, or put it inside a comment if the control allows it there.",
         *           "alarm": null,
         *           "notes": [],
         *           "fix": {
         *             "line": 7,
         *             "column_chars": 7,
         *             "end_line": 7,
         *             "end_column_chars": 8,
         *             "text": "N"
         *           }
         *         },
         *         {
         *           "id": "jump-target-missing",
         *           "severity": "error",
         *           "line": 8,
         *           "column_chars": 1,
         *           "end_line": 8,
         *           "end_column_chars": 7,
         *           "text": "the jump target N20 is not in the program",
         *           "help": "Write the label or block number at the target, or check the direction in which the jump looks.",
         *           "alarm": "PS0128",
         *           "notes": [],
         *           "fix": null
         *         },
         *         {
         *           "id": "unreachable",
         *           "severity": "warning",
         *           "line": 9,
         *           "column_chars": 1,
         *           "end_line": 9,
         *           "end_column_chars": 4,
         *           "text": "the block is never reached",
         *           "help": "No control-flow path leads here: a jump or the program's end stands before it.",
         *           "alarm": null,
         *           "notes": [],
         *           "fix": null
         *         }
         *       ],
         *       "folded": [],
         *       "outline": [
         *         {
         *           "sort": "program",
         *           "line": 2,
         *           "text": "O0100 (PUMP)"
         *         },
         *         {
         *           "sort": "tool",
         *           "line": 4,
         *           "text": "T5 M6"
         *         },
         *         {
         *           "sort": "call",
         *           "line": 6,
         *           "text": "M98 P200"
         *         }
         *       ],
         *       "outline_is_cut": false
         *     }
         */
        Diagnosed: {
            /** @description in which it was read */
            dialect: string;
            /** @description as which control the text was read */
            control: {
                /** @description for people */
                title: string;
                /**
                 * @description of machine
                 * @enum {string}
                 */
                kind: "mill" | "lathe" | "mill-turn";
                /**
                 * @description G code system of a lathe
                 * @enum {string}
                 */
                g_system: "A" | "B" | "C";
                /**
                 * @description at power-on
                 * @enum {string}
                 */
                feed_mode: "per-minute" | "per-revolution" | "inverse-time";
                /** @description by which it was inferred; 0: it was named, or is the default */
                because_line: number;
                /** @description the control was inferred from the text */
                inferred: boolean;
            };
            /** @description in the order of the text; the first of each kind */
            faults: {
                /** @description of the kind of fault */
                id: string;
                /**
                 * @description how bad it is
                 * @enum {string}
                 */
                severity: "note" | "warning" | "error";
                /** @description where it begins, from 1 */
                line: number;
                /** @description where it begins, from 1, in characters */
                column_chars: number;
                /** @description where it ends */
                end_line: number;
                /** @description of the first character after it */
                end_column_chars: number;
                /** @description one sentence */
                text: string;
                /** @description the fault and its cure */
                help: string;
                /** @description by which the control itself would name it */
                alarm: string | null;
                /** @description elsewhere in the text */
                notes: {
                    /** @description of the text */
                    line: number;
                    /** @description one sentence */
                    text: string;
                }[];
                /** @description what would mend it; null: nothing for certain */
                fix: {
                    /** @description where it begins, from 1 */
                    line: number;
                    /** @description where it begins, from 1, in characters */
                    column_chars: number;
                    /** @description where it ends */
                    end_line: number;
                    /** @description of the first character after it */
                    end_column_chars: number;
                    /** @description that stands in its place then */
                    text: string;
                } | null;
            }[];
            /** @description of the diagnostics */
            folded: {
                /** @description of the kind of fault */
                id: string;
                /**
                 * @description how bad it is
                 * @enum {string}
                 */
                severity: "note" | "warning" | "error";
                /** @description that are not listed */
                more: number;
            }[];
            /** @description programs, labels, calls, tools and stops in the order of the text */
            outline: {
                /**
                 * @description of place
                 * @enum {string}
                 */
                sort: "program" | "label" | "call" | "tool" | "stop";
                /** @description of the text */
                line: number;
                /** @description of that line */
                text: string;
            }[];
            /** @description there are more places than these */
            outline_is_cut: boolean;
        };
        /**
         * @description the programs of a text
         * @example {
         *       "programs": [
         *         {
         *           "name": "O0001",
         *           "comment": "HOUSING",
         *           "text": "%\nO0001(HOUSING)\nM98P2\nM30\n%\n"
         *         },
         *         {
         *           "name": "O0002",
         *           "comment": null,
         *           "text": "%\nO0002\nM99\n%\n"
         *         }
         *       ]
         *     }
         */
        SplitText: {
            /** @description in their order; one where the text is not several */
            programs: {
                /** @description that it gives itself; null: none */
                name: string | null;
                /** @description its first; null: none */
                comment: string | null;
                /** @description with its own line ends */
                text: string;
            }[];
        };
        /**
         * @description a text in another control's language; it is not stored
         * @example {
         *       "from": "sinumerik-840d",
         *       "to": "fanuc",
         *       "mode": "macro",
         *       "text": null,
         *       "verified": false,
         *       "not_verified": null,
         *       "origins": [],
         *       "diagnostics": [
         *         {
         *           "id": "unit-not-stated",
         *           "severity": "error",
         *           "file": null,
         *           "line": 3,
         *           "column": 1,
         *           "column_chars": 1,
         *           "text": "the program moves before it states inch or millimetre",
         *           "alarm": null
         *         },
         *         {
         *           "id": "distance-mode-not-stated",
         *           "severity": "warning",
         *           "file": null,
         *           "line": 3,
         *           "column": 1,
         *           "column_chars": 1,
         *           "text": "the program moves before it states absolute or incremental",
         *           "alarm": null
         *         },
         *         {
         *           "id": "translation-value",
         *           "severity": "error",
         *           "file": null,
         *           "line": 2,
         *           "column": 4,
         *           "column_chars": 4,
         *           "text": "the system variable GETT(\"X\",1) has no counterpart on Fanuc 0i-MF",
         *           "alarm": null
         *         }
         *       ],
         *       "folded": []
         *     }
         */
        Converted: {
            /** @description dialect that it was read in */
            from: string;
            /** @description dialect that it was translated to */
            to: string;
            /**
             * @description of translation
             * @enum {string}
             */
            mode: "macro" | "explicit";
            /** @description the translation; null: refused, and the diagnostics state why */
            text: string | null;
            /** @description both texts were run and made the same moves */
            verified: boolean;
            /** @description why that cannot be stated; null: it is, or nothing was translated */
            not_verified: string | null;
            /** @description where each line of the translation comes from; empty: the text itself */
            origins: number[];
            /** @description of the given text; the first of each kind */
            diagnostics: {
                /** @description of the kind of fault */
                id: string;
                /**
                 * @description how bad it is
                 * @enum {string}
                 */
                severity: "note" | "warning" | "error";
                /** @description the called program that it is in; null: the text itself */
                file: string | null;
                /** @description from 1 */
                line: number;
                /** @description from 1, in bytes */
                column: number;
                /** @description from 1, in characters */
                column_chars: number;
                /** @description one sentence */
                text: string;
                /** @description by which the control itself would name it */
                alarm: string | null;
            }[];
            /** @description of the diagnostics */
            folded: {
                /** @description of the kind of fault */
                id: string;
                /**
                 * @description how bad it is
                 * @enum {string}
                 */
                severity: "note" | "warning" | "error";
                /** @description that are not listed */
                more: number;
            }[];
        };
        /**
         * @description a text made faster for its control; it is not stored
         * @example {
         *       "text": "G21 G90 G94 G17 G40\nT1 M6\nG54\nS900 M3\nG0 X0 Y0 Z5.\nG1 Z-1. F100\nX3. Y3.\nM30\n",
         *       "origins": [
         *         1,
         *         2,
         *         3
         *       ],
         *       "passes": [
         *         {
         *           "rule": "lines",
         *           "edits": 1,
         *           "saved": {
         *             "ms": 4,
         *             "least_ms": 0.8,
         *             "most_ms": 20
         *           }
         *         }
         *       ],
         *       "changes": [
         *         {
         *           "line": 7,
         *           "rule": "lines",
         *           "what": "3 blocks are one, 0.000707 mm off at most"
         *         }
         *       ],
         *       "left_because": null,
         *       "not_verified": null,
         *       "proved_max_mm": 0.0007,
         *       "not_merged": null,
         *       "not_tabulated": null,
         *       "not_inlined": [],
         *       "saved": {
         *         "ms": 4,
         *         "least_ms": 0.8,
         *         "most_ms": 20
         *       },
         *       "before": {
         *         "total_ms": 20,
         *         "longest_ms": 10,
         *         "longest_line": 5,
         *         "moves": 5,
         *         "blocks": 10
         *       },
         *       "after": {
         *         "total_ms": 16,
         *         "longest_ms": 10,
         *         "longest_line": 5,
         *         "moves": 3,
         *         "blocks": 8
         *       },
         *       "cost": {
         *         "source": "assumed",
         *         "origin": "0i class",
         *         "spread": 5
         *       },
         *       "diagnostics": []
         *     }
         */
        Optimized: {
            /** @description the new text; unchanged where nothing was gained; null: it could not be read */
            text: string | null;
            /** @description where each line of the new text comes from; empty: it is unchanged */
            origins: number[];
            /** @description in the order of the rules */
            passes: {
                /**
                 * @description that was applied
                 * @enum {string}
                 */
                rule: "inline" | "numbered" | "loops" | "branches" | "values" | "invariants" | "merge" | "join" | "comments" | "numbers" | "table" | "lines" | "arcs";
                /** @description how many of the changes are its own */
                edits: number;
                /** @description next to the text with the rules before it alone; null: not run */
                saved: {
                    /** @description by the cost model; below zero: it costs more */
                    ms: number;
                    /** @description if each figure of the model is off to its disadvantage */
                    least_ms: number;
                    /** @description if each is off to its advantage */
                    most_ms: number;
                } | null;
            }[];
            /** @description in the order in which they were made */
            changes: {
                /** @description of the given text */
                line: number;
                /**
                 * @description that was applied
                 * @enum {string}
                 */
                rule: "inline" | "numbered" | "loops" | "branches" | "values" | "invariants" | "merge" | "join" | "comments" | "numbers" | "table" | "lines" | "arcs";
                /** @description a clause */
                what: string;
            }[];
            /** @description why the text is unchanged; null: it is not */
            left_because: string | null;
            /** @description why running both does not show that they move the same; null: it does */
            not_verified: string | null;
            /** @description how far both paths lie apart at most, where a rule changed it; null: they are the same */
            proved_max_mm: number | null;
            /** @description why no blocks were merged; null: they were, or it was not asked for */
            not_merged: string | null;
            /** @description why no formula is a table; null: one is, or it was not asked for */
            not_tabulated: string | null;
            /** @description in the order of the text; empty where the rule is off */
            not_inlined: {
                /** @description of the given text */
                line: number;
                /** @description that is called; null: a value decides */
                program: string | null;
                /** @description a clause */
                why: string;
            }[];
            /** @description by all rules; null: it was not run */
            saved: {
                /** @description by the cost model; below zero: it costs more */
                ms: number;
                /** @description if each figure of the model is off to its disadvantage */
                least_ms: number;
                /** @description if each is off to its advantage */
                most_ms: number;
            } | null;
            /** @description what the given text's run costs; null: it was not run */
            before: {
                /** @description of all that is computed */
                total_ms: number;
                /** @description computed before one move, at most */
                longest_ms: number;
                /** @description of the text, where that move is */
                longest_line: number;
                /** @description of the run */
                moves: number;
                /** @description that were executed */
                blocks: number;
            } | null;
            /** @description what the new text's run costs; null: it was not run */
            after: {
                /** @description of all that is computed */
                total_ms: number;
                /** @description computed before one move, at most */
                longest_ms: number;
                /** @description of the text, where that move is */
                longest_line: number;
                /** @description of the run */
                moves: number;
                /** @description that were executed */
                blocks: number;
            } | null;
            /** @description the cost model */
            cost: {
                /**
                 * @description of its figures
                 * @enum {string}
                 */
                source: "assumed" | "paper" | "calibrated";
                /** @description where they are from */
                origin: string;
                /** @description each time lies between time / spread and time * spread */
                spread: number;
            };
            /** @description of reading the given text */
            diagnostics: {
                /** @description of the kind of fault */
                id: string;
                /**
                 * @description how bad it is
                 * @enum {string}
                 */
                severity: "note" | "warning" | "error";
                /** @description the called program that it is in; null: the text itself */
                file: string | null;
                /** @description from 1 */
                line: number;
                /** @description from 1, in bytes */
                column: number;
                /** @description from 1, in characters */
                column_chars: number;
                /** @description one sentence */
                text: string;
                /** @description by which the control itself would name it */
                alarm: string | null;
            }[];
        };
        /**
         * @description a rewritten text; it is not stored
         * @example {
         *       "text": "%\nO0100 (PUMP)\nN100 G21 G17 G90 G94 G54\nN200 T5 M6\nN300 G0 X0. Y0.\nN400 M98 P200\nN500 G1 X10. F100.\nN600 GOTO500\nN700 M30\n%\n",
         *       "numbers": 7,
         *       "references": 1,
         *       "assumptions": [
         *         "the programs that it calls name no block of it (M99 P, RET, GOTO of the caller)"
         *       ],
         *       "refused": []
         *     }
         */
        Rewritten: {
            /** @description the same program; null: refused */
            text: string | null;
            /** @description blocks that have a number now; where numbers were asked for */
            numbers: number;
            /** @description words that name one of them */
            references: number;
            /** @description what was taken for granted */
            assumptions: string[];
            /** @description none: it was done */
            refused: {
                /** @description of the given text; null: of none */
                line: number | null;
                /** @description why */
                text: string;
            }[];
        };
        /**
         * @description the words of a control's language
         * @example {
         *       "dialect": "fanuc",
         *       "title": "Fanuc 0i-MF",
         *       "comment": {
         *         "open": "(",
         *         "close": ")"
         *       },
         *       "touching": true,
         *       "words": [
         *         {
         *           "word": "G00",
         *           "sort": "code",
         *           "about": "rapid",
         *           "reference": "0i-F B-64604EN, G code list; Mazak and Mitsubishi alike",
         *           "last": null
         *         },
         *         {
         *           "word": "G01",
         *           "sort": "code",
         *           "about": "linear",
         *           "reference": "0i-F B-64604EN, G code list; Mazak and Mitsubishi alike",
         *           "last": null
         *         },
         *         {
         *           "word": "G02",
         *           "sort": "code",
         *           "about": "arc clockwise",
         *           "reference": "0i-F B-64604EN, G code list; Mazak and Mitsubishi alike",
         *           "last": null
         *         }
         *       ]
         *     }
         */
        DialectWords: {
            /** @description its name */
            dialect: string;
            /** @description of the control, for people */
            title: string;
            /** @description what a comment stands in */
            comment: {
                /** @description its start */
                open: string;
                /** @description null: the end of the line */
                close: string | null;
            };
            /** @description words may follow each other without blanks: XROUND[#1] is X and ROUND */
            touching: boolean;
            /** @description each once */
            words: {
                /** @description as the control's manual writes it */
                word: string;
                /**
                 * @description of word
                 * @enum {string}
                 */
                sort: "code" | "keyword" | "function" | "cycle" | "variable";
                /** @description a few words */
                about: string;
                /** @description manual and section; null: none */
                reference: string | null;
                /** @description of numbered variables the last; null: just one */
                last: number | null;
            }[];
        };
        /**
         * @description what is known of a program's toolpath: the programmed one, without tool radius compensation, in the active work offset
         * @example {
         *       "dialect": "fanuc",
         *       "control": {
         *         "title": "Fanuc 0i-TF",
         *         "kind": "lathe",
         *         "g_system": "A",
         *         "feed_mode": "per-revolution",
         *         "because_line": 0,
         *         "inferred": false
         *       },
         *       "x_is_diameter": true,
         *       "segments": 3,
         *       "low_mm": [
         *         0,
         *         0,
         *         -1
         *       ],
         *       "high_mm": [
         *         5,
         *         0,
         *         5
         *       ],
         *       "cut_mm": 11,
         *       "rapid_mm": 6,
         *       "not_drawn": [
         *         {
         *           "why": "unknown_place",
         *           "moves": 1,
         *           "first_line": 4
         *         }
         *       ],
         *       "other_axes": [],
         *       "work_offsets": [
         *         1
         *       ],
         *       "compensated": false,
         *       "is_cut_off": false,
         *       "ran": true,
         *       "not_known": [
         *         "Y: not interpreted (line 4)"
         *       ],
         *       "diagnostics": [
         *         {
         *           "id": "codes-of-one-group",
         *           "severity": "warning",
         *           "file": null,
         *           "line": 3,
         *           "column": 13,
         *           "column_chars": 13,
         *           "text": "G90 and G94 are of the same group and stand in one block",
         *           "alarm": null
         *         },
         *         {
         *           "id": "unknown-address",
         *           "severity": "error",
         *           "file": null,
         *           "line": 4,
         *           "column": 7,
         *           "column_chars": 7,
         *           "text": "the control has no address Y",
         *           "alarm": "PS0009"
         *         }
         *       ],
         *       "time": {
         *         "cycle_s": 0.108,
         *         "is_fed": false,
         *         "notes": [
         *           "a move starts at a position that is not known: its length is not counted (line 4)",
         *           "a move has no feed, or a feed per revolution and no spindle speed: its time is not counted (line 5)"
         *         ]
         *       },
         *       "why_no_time": null,
         *       "deviation": null,
         *       "tools": [
         *         {
         *           "tool": null,
         *           "shape": null
         *         }
         *       ],
         *       "tool_changes": [
         *         {
         *           "point": 0,
         *           "tool": 0
         *         }
         *       ],
         *       "points": 4,
         *       "kind_names": [
         *         "begin",
         *         "rapid",
         *         "cut_per_min"
         *       ],
         *       "columns": {
         *         "points_mm": "AAAAAAAAAAAAAKBAAAAAAAAAAAAAAIC/AACgQAAAAAAAAIC/AACgQAAAAAAAAKBA",
         *         "kinds": "AAMDAQ==",
         *         "lines": "BAAAAAUAAAAGAAAABwAAAA==",
         *         "feeds": "AAAAAAAAyEIAAMhCAAAAAA==",
         *         "times_s": "bxKDO6abxDtvEgM8ZyTdPQ==",
         *         "speeds": "AADAfwAAwH8AAMB/waNlRQ==",
         *         "buffer": "",
         *         "deviations_mm": ""
         *       }
         *     }
         */
        ToolPath: {
            /** @description in which the text was read */
            dialect: string;
            /** @description as which control the text was read */
            control: {
                /** @description for people */
                title: string;
                /**
                 * @description of machine
                 * @enum {string}
                 */
                kind: "mill" | "lathe" | "mill-turn";
                /**
                 * @description G code system of a lathe
                 * @enum {string}
                 */
                g_system: "A" | "B" | "C";
                /**
                 * @description at power-on
                 * @enum {string}
                 */
                feed_mode: "per-minute" | "per-revolution" | "inverse-time";
                /** @description by which it was inferred; 0: it was named, or is the default */
                because_line: number;
                /** @description the control was inferred from the text */
                inferred: boolean;
            };
            /** @description the program's x words are diameters */
            x_is_diameter: boolean;
            /** @description straight ones; an arc is chords with a deviation of 0.005 mm at most */
            segments: number;
            /** @description the lowest of all points */
            low_mm: number[];
            /** @description the highest of all points */
            high_mm: number[];
            /** @description length of all cuts and threads */
            cut_mm: number;
            /** @description length of all rapids, as straight lines */
            rapid_mm: number;
            /** @description each reason once */
            not_drawn: {
                /**
                 * @description they are not there
                 * @enum {string}
                 */
                why: "unknown_place" | "machine_coordinates" | "no_place";
                /** @description of that kind */
                moves: number;
                /** @description of the first one; 0: in a called program */
                first_line: number;
            }[];
            /** @description that move, other than x, y and z */
            other_axes: string[];
            /** @description that the moves lie in; their zeros are drawn in one place */
            work_offsets: number[];
            /** @description moves have tool radius compensation, which the path does not have */
            compensated: boolean;
            /** @description there are more points than these */
            is_cut_off: boolean;
            /** @description the program ran to its end */
            ran: boolean;
            /** @description what the run found and did not know, as in a verdict */
            not_known: string[];
            /** @description of reading, validating and running the text; the first of each kind */
            diagnostics: {
                /** @description of the kind of fault */
                id: string;
                /**
                 * @description how bad it is
                 * @enum {string}
                 */
                severity: "note" | "warning" | "error";
                /** @description the called program that it is in; null: the text itself */
                file: string | null;
                /** @description from 1 */
                line: number;
                /** @description from 1, in bytes */
                column: number;
                /** @description from 1, in characters */
                column_chars: number;
                /** @description one sentence */
                text: string;
                /** @description by which the control itself would name it */
                alarm: string | null;
            }[];
            /** @description when the points are reached on the machine; null: not known */
            time: {
                /** @description of the whole program, all waiting included */
                cycle_s: number;
                /** @description it is fed over the machine's line while it runs */
                is_fed: boolean;
                /** @description what they leave out */
                notes: string[];
            } | null;
            /** @description why no times are known; null: they are */
            why_no_time: string | null;
            /** @description how far from the nominal the blocks cut; null: no nominal is known */
            deviation: {
                /** @description that the tool leaves; otherwise of the path */
                of_surface: boolean;
                /** @description what they leave out */
                notes: string[];
            } | null;
            /** @description in the order in which they are taken first */
            tools: {
                /** @description as the program names it; null: none is taken */
                tool: string | null;
                /** @description its shape, as the machine's profile or the family has it; null: not known */
                shape: {
                    /** @description of a mill; null: not known */
                    diameter_mm: number | null;
                    /** @description of a mill: 0 is flat */
                    corner_radius_mm: number;
                    /** @description of a turning tool */
                    nose_radius_mm: number;
                    /** @description of a turning tool, 0 to 9; 0 of others */
                    tip: number;
                    /** @description from the gauge line to the tip; null: not known */
                    length_mm: number | null;
                    /** @description of a turning tool; null: not known */
                    insert: {
                        /** @description between its two edges */
                        angle_deg: number;
                        /** @description of the leading edge against the direction of feed */
                        entering_angle_deg: number;
                        /** @description length of an edge */
                        edge_mm: number;
                    } | null;
                    /** @description shank and holder of a mill, from below; empty: not known */
                    holder: {
                        /** @description above the tip */
                        from_mm: number;
                        /** @description up to the next step */
                        diameter_mm: number;
                    }[];
                } | null;
            }[];
            /** @description in the order of the path */
            tool_changes: {
                /** @description from 0 */
                point: number;
                /** @description of tools, from 0 */
                tool: number;
            }[];
            /** @description rows of the columns */
            points: number;
            /** @description by the numbers of the column */
            kind_names: ("begin" | "rapid" | "cut_per_min" | "cut_per_rev" | "cut_inverse_time" | "thread")[];
            /** @description one row for each point; numbers little-endian, as base64 */
            columns: {
                /** @description x y z as 32-bit floats, x as radius */
                points_mm: string;
                /** @description what leads to the point, a byte; begin: nothing does */
                kinds: string;
                /** @description of the program's text as 32-bit integers; 0: in a called program */
                lines: string;
                /** @description as programmed, 32-bit floats: mm/min, mm/rev or 1/min by the kind */
                feeds: string;
                /** @description when the point is reached, 32-bit floats; NaN: not known; empty: of none */
                times_s: string;
                /** @description mean speed of the segment to the point, mm/min, 32-bit floats; NaN: not known; empty: of none */
                speeds: string;
                /** @description bytes in the control when the motion to the point begins, 32-bit integers; empty: nothing is fed */
                buffer: string;
                /** @description of what the point's block cuts from the nominal, 32-bit floats; positive: material is left; NaN: not measured; empty: of none */
                deviations_mm: string;
            };
        };
        /**
         * @description a program's toolpath as a small drawing of lines
         * @example {
         *       "view": "turning",
         *       "width": 240,
         *       "height": 180,
         *       "cut": "M234 64 213 116 213 115M213 116 212 116 212 115M212 116 211 115 211 116M211 115 210 115 210 116 209 116 209 115 208 115 208 116M208 115 207 116 207 115M207 116 206 116 206 115 205 115 205 116 204 116 204 115M204 116 203 115 203 116M203 115 202 115 202 116 201 116 201 115 200 115 200 116M200 115 199 ",
         *       "rapid": "M6 115 6 64",
         *       "has_all_cuts": true
         *     }
         */
        PathPicture: {
            /**
             * @description of it: turning has z to the right and x up
             * @enum {string}
             */
            view: "turning" | "isometric";
            /** @description of the drawing; its top left is 0 0 */
            width: number;
            /** @description of the drawing */
            height: number;
            /** @description path data as SVG has them; empty: no cut is known */
            cut: string;
            /** @description path data; may lie outside of the drawing; empty: no rapid is known */
            rapid: string;
            /** @description it was run to its end, and no cut lies at a position that is not known */
            has_all_cuts: boolean;
        };
        /**
         * @description what a text amounts to; without the programs that it calls
         * @example {
         *       "dialect": "fanuc",
         *       "control": {
         *         "title": "Fanuc 0i-MF",
         *         "kind": "mill",
         *         "g_system": "A",
         *         "feed_mode": "per-minute",
         *         "because_line": 3,
         *         "inferred": true
         *       },
         *       "x_is_diameter": false,
         *       "segments": 3,
         *       "low_mm": [
         *         0,
         *         0,
         *         0
         *       ],
         *       "high_mm": [
         *         60,
         *         0,
         *         5
         *       ],
         *       "cut_mm": 65,
         *       "rapid_mm": 60,
         *       "not_drawn": [
         *         {
         *           "why": "unknown_place",
         *           "moves": 1,
         *           "first_line": 4
         *         }
         *       ],
         *       "other_axes": [],
         *       "work_offsets": [
         *         1
         *       ],
         *       "compensated": false,
         *       "is_cut_off": false,
         *       "ran": true,
         *       "not_known": [],
         *       "diagnostics": [
         *         {
         *           "id": "missing-tape-mark",
         *           "severity": "warning",
         *           "file": null,
         *           "line": 1,
         *           "column": 1,
         *           "column_chars": 1,
         *           "text": "the first % is missing",
         *           "alarm": null
         *         },
         *         {
         *           "id": "length-offset-missing",
         *           "severity": "warning",
         *           "file": null,
         *           "line": 4,
         *           "column": 1,
         *           "column_chars": 1,
         *           "text": "Z moves with tool T1 and no tool length is in effect",
         *           "alarm": null
         *         },
         *         {
         *           "id": "spindle-not-turning",
         *           "severity": "warning",
         *           "file": null,
         *           "line": 6,
         *           "column": 1,
         *           "column_chars": 1,
         *           "text": "a cut begins while the spindle is stopped",
         *           "alarm": null
         *         }
         *       ],
         *       "lines": 9,
         *       "bytes": 82,
         *       "blocks": 8,
         *       "time_s": null,
         *       "why_no_time": "no machine is named: its axes decide",
         *       "tools": [
         *         {
         *           "tool": "T1",
         *           "first_line": 3,
         *           "cut_mm": 65,
         *           "rapid_mm": 0,
         *           "time_s": null
         *         },
         *         {
         *           "tool": "T2",
         *           "first_line": 7,
         *           "cut_mm": 0,
         *           "rapid_mm": 60,
         *           "time_s": null
         *         }
         *       ]
         *     }
         */
        Statistics: {
            /** @description in which the text was read */
            dialect: string;
            /** @description as which control the text was read */
            control: {
                /** @description for people */
                title: string;
                /**
                 * @description of machine
                 * @enum {string}
                 */
                kind: "mill" | "lathe" | "mill-turn";
                /**
                 * @description G code system of a lathe
                 * @enum {string}
                 */
                g_system: "A" | "B" | "C";
                /**
                 * @description at power-on
                 * @enum {string}
                 */
                feed_mode: "per-minute" | "per-revolution" | "inverse-time";
                /** @description by which it was inferred; 0: it was named, or is the default */
                because_line: number;
                /** @description the control was inferred from the text */
                inferred: boolean;
            };
            /** @description the program's x words are diameters */
            x_is_diameter: boolean;
            /** @description straight ones; an arc is chords with a deviation of 0.005 mm at most */
            segments: number;
            /** @description the lowest of all points */
            low_mm: number[];
            /** @description the highest of all points */
            high_mm: number[];
            /** @description length of all cuts and threads */
            cut_mm: number;
            /** @description length of all rapids, as straight lines */
            rapid_mm: number;
            /** @description each reason once */
            not_drawn: {
                /**
                 * @description they are not there
                 * @enum {string}
                 */
                why: "unknown_place" | "machine_coordinates" | "no_place";
                /** @description of that kind */
                moves: number;
                /** @description of the first one; 0: in a called program */
                first_line: number;
            }[];
            /** @description that move, other than x, y and z */
            other_axes: string[];
            /** @description that the moves lie in; their zeros are drawn in one place */
            work_offsets: number[];
            /** @description moves have tool radius compensation, which the path does not have */
            compensated: boolean;
            /** @description there are more points than these */
            is_cut_off: boolean;
            /** @description the program ran to its end */
            ran: boolean;
            /** @description what the run found and did not know, as in a verdict */
            not_known: string[];
            /** @description of reading, validating and running the text; the first of each kind */
            diagnostics: {
                /** @description of the kind of fault */
                id: string;
                /**
                 * @description how bad it is
                 * @enum {string}
                 */
                severity: "note" | "warning" | "error";
                /** @description the called program that it is in; null: the text itself */
                file: string | null;
                /** @description from 1 */
                line: number;
                /** @description from 1, in bytes */
                column: number;
                /** @description from 1, in characters */
                column_chars: number;
                /** @description one sentence */
                text: string;
                /** @description by which the control itself would name it */
                alarm: string | null;
            }[];
            /** @description of the text */
            lines: number;
            /** @description of the text */
            bytes: number;
            /** @description that were executed */
            blocks: number;
            /** @description of all moves, dwells and tool changes, without waiting for control or line; null: not known */
            time_s: number | null;
            /** @description why no time is known; null: it is */
            why_no_time: string | null;
            /** @description in the order in which they are taken first */
            tools: {
                /** @description as the program names it; null: before any is taken */
                tool: string | null;
                /** @description that takes it; null: none of the text */
                first_line: number | null;
                /** @description length of its cuts and threads */
                cut_mm: number;
                /** @description length of its rapids */
                rapid_mm: number;
                /** @description of its moves, dwells and change; null: not known */
                time_s: number | null;
            }[];
        };
        /**
         * @description how far a program lies from the nominal
         * @example {
         *       "blocks": 2001,
         *       "points": 4605,
         *       "max_mm": 84.612,
         *       "max_at_line": 2003,
         *       "mean_mm": 74.6089,
         *       "rmse_mm": 75.0073,
         *       "chord_bound_mm": 84.7465,
         *       "measured": "surface",
         *       "path": {
         *         "points": 6599,
         *         "max_mm": -84.7465,
         *         "max_at_line": 2003,
         *         "max_at": [
         *           -99.75,
         *           25
         *         ],
         *         "mean_mm": 76.3879,
         *         "rmse_mm": 76.639
         *       },
         *       "surface": {
         *         "points": 4605,
         *         "max_mm": -84.612,
         *         "max_at_line": 2003,
         *         "max_at": [
         *           -99.098,
         *           25.0138
         *         ],
         *         "mean_mm": 74.6089,
         *         "rmse_mm": 75.0073
         *       },
         *       "overrun_mm": 0,
         *       "covered": false,
         *       "findings": [
         *         {
         *           "id": "deviation-beyond-tolerance",
         *           "severity": "error",
         *           "line": 8,
         *           "program": 0,
         *           "value": 75.0007,
         *           "limit": 0.02,
         *           "text": "the surface is -75.0007 mm off the nominal at z 0.801, the tolerance is 0.02",
         *           "alarm": null
         *         },
         *         {
         *           "id": "deviation-beyond-tolerance",
         *           "severity": "error",
         *           "line": 8,
         *           "program": 0,
         *           "value": 74.4996,
         *           "limit": 0.02,
         *           "text": "the surface is -74.4996 mm off the nominal at z 1.543, the tolerance is 0.02",
         *           "alarm": null
         *         },
         *         {
         *           "id": "deviation-beyond-tolerance",
         *           "severity": "error",
         *           "line": 9,
         *           "program": 0,
         *           "value": 74.7657,
         *           "limit": 0.02,
         *           "text": "the surface is -74.7657 mm off the nominal at z 0.234, the tolerance is 0.02",
         *           "alarm": null
         *         }
         *       ],
         *       "counts": {
         *         "deviation-beyond-tolerance": 1717,
         *         "nominal-not-covered": 1
         *       },
         *       "validated": true,
         *       "not_checked": []
         *     }
         */
        AccuracyFigures: {
            /** @description that were measured */
            blocks: number;
            /** @description places that were measured */
            points: number;
            /** @description size of the largest deviation */
            max_mm: number;
            /** @description of the program; 0: none */
            max_at_line: number;
            /** @description of the size, along the path */
            mean_mm: number;
            /** @description root of the mean square */
            rmse_mm: number;
            /** @description proved from the curve; null: none */
            chord_bound_mm: number | null;
            /**
             * @description of what the figures above are
             * @enum {string}
             */
            measured: "surface" | "path";
            /** @description of the programmed path */
            path: {
                /** @description places that were measured */
                points: number;
                /** @description largest deviation; positive: material is left, negative: too much is taken */
                max_mm: number;
                /** @description of the program; 0: none */
                max_at_line: number;
                /** @description where; turning: Z and radius, milling: X and Y */
                max_at: number[];
                /** @description of the size, along the path */
                mean_mm: number;
                /** @description root of the mean square */
                rmse_mm: number;
            };
            /** @description of what the tool leaves; null: the tool is not known */
            surface: {
                /** @description places that were measured */
                points: number;
                /** @description largest deviation; positive: material is left, negative: too much is taken */
                max_mm: number;
                /** @description of the program; 0: none */
                max_at_line: number;
                /** @description where; turning: Z and radius, milling: X and Y */
                max_at: number[];
                /** @description of the size, along the path */
                mean_mm: number;
                /** @description root of the mean square */
                rmse_mm: number;
            } | null;
            /** @description farthest reach of the path beyond the ends of the nominal */
            overrun_mm: number;
            /** @description the path passes all of the nominal */
            covered: boolean;
            /** @description the first ones of each kind */
            findings: {
                /** @description of the kind of finding */
                id: string;
                /**
                 * @description how bad it is
                 * @enum {string}
                 */
                severity: "note" | "warning" | "error";
                /** @description of the program, from 1; 0: of the whole */
                line: number;
                /** @description index into `programs`; 0: the main one */
                program: number;
                /** @description that was found */
                value: number | null;
                /** @description that it breaks */
                limit: number | null;
                /** @description one sentence */
                text: string;
                /** @description by which the control itself would name it */
                alarm: string | null;
            }[];
            /** @description all findings, by their id */
            counts: {
                [key: string]: number;
            };
            /** @description the text was validated before it ran */
            validated: boolean;
            /** @description points that were measured at a part, compared with the nominal */
            cmm?: {
                /** @description measured points */
                points: number;
                /** @description least deviation, with its sign */
                min_mm: number;
                /** @description greatest deviation, with its sign */
                max_mm: number;
                /** @description with its sign */
                mean_mm: number;
                /** @description root of the mean square */
                rmse_mm: number;
                /** @description of the largest deviation, from 1 */
                max_at_row: number;
                /** @description after the part is shifted and turned to fit best */
                best_fit?: {
                    /** @description measured points */
                    points: number;
                    /** @description least deviation, with its sign */
                    min_mm: number;
                    /** @description greatest deviation, with its sign */
                    max_mm: number;
                    /** @description with its sign */
                    mean_mm: number;
                    /** @description root of the mean square */
                    rmse_mm: number;
                    /** @description of the largest deviation, from 1 */
                    max_at_row: number;
                    /** @description of the part: Z and X, or X and Y */
                    shift_mm: number[];
                    /** @description of the part */
                    turn_deg: number;
                };
            };
            /** @description what was not checked, and why */
            not_checked: string[];
        };
        /**
         * @description where a program cuts what it must not
         * @example {
         *       "findings": [
         *         {
         *           "id": "rapid-into-nominal",
         *           "severity": "error",
         *           "line": 7,
         *           "program": 0,
         *           "value": 50.127,
         *           "limit": 0,
         *           "text": "a rapid move enters the finished part by 50.127 mm at z 10.800",
         *           "alarm": null
         *         },
         *         {
         *           "id": "cut-below-nominal",
         *           "severity": "error",
         *           "line": 8,
         *           "program": 0,
         *           "value": 75.0007,
         *           "limit": 0.02,
         *           "text": "the cut is 75.001 mm below the nominal at z 0.800, the tolerance is 0.02",
         *           "alarm": null
         *         },
         *         {
         *           "id": "cut-below-nominal",
         *           "severity": "error",
         *           "line": 10,
         *           "program": 0,
         *           "value": 74.9506,
         *           "limit": 0.02,
         *           "text": "the cut is 74.951 mm below the nominal at z 0.750, the tolerance is 0.02",
         *           "alarm": null
         *         }
         *       ],
         *       "counts": {
         *         "rapid-into-nominal": 2,
         *         "cut-below-nominal": 2001
         *       },
         *       "rapids": 2,
         *       "cuts": 2001,
         *       "deepest_rapid_mm": 84.4126,
         *       "deepest_cut_mm": 84.612,
         *       "validated": true,
         *       "not_checked": [
         *         "a move starts at a position that is not known: its end alone was checked (line 7)"
         *       ]
         *     }
         */
        GougeFigures: {
            /** @description the first ones of each kind */
            findings: {
                /** @description of the kind of finding */
                id: string;
                /**
                 * @description how bad it is
                 * @enum {string}
                 */
                severity: "note" | "warning" | "error";
                /** @description of the program, from 1; 0: of the whole */
                line: number;
                /** @description index into `programs`; 0: the main one */
                program: number;
                /** @description that was found */
                value: number | null;
                /** @description that it breaks */
                limit: number | null;
                /** @description one sentence */
                text: string;
                /** @description by which the control itself would name it */
                alarm: string | null;
            }[];
            /** @description all findings, by their id */
            counts: {
                [key: string]: number;
            };
            /** @description that were checked */
            rapids: number;
            /** @description that were checked */
            cuts: number;
            /** @description into stock or part */
            deepest_rapid_mm: number;
            /** @description below the nominal */
            deepest_cut_mm: number;
            /** @description the text was validated before it ran */
            validated: boolean;
            /** @description what was not checked, and why */
            not_checked: string[];
        };
        /**
         * @description how long a program takes on its machine and line
         * @example {
         *       "blocks": 2009,
         *       "cycle_s": 142.6474,
         *       "motion_s": 142.6239,
         *       "compute_s": 4.018,
         *       "line_s": 27.5898,
         *       "stalls": 0,
         *       "stall_s": 0,
         *       "first_stall_line": 0,
         *       "compute_low_s": 0.8036,
         *       "compute_high_s": 20.09,
         *       "compute_source": "assumed",
         *       "compute_origin": "0i class",
         *       "standstill_s": 0,
         *       "first_stall_at_s": 0,
         *       "longest_standstill_s": 0,
         *       "longest_standstill_line": 0,
         *       "first_move_s": 0.0235,
         *       "rapid_s": 0.199,
         *       "path_mm": 259.624,
         *       "blocks_per_s": 14.0837,
         *       "limited_s": {
         *         "motion": 142.6239,
         *         "compute": 0,
         *         "line": 0,
         *         "buffer": 0
         *       },
         *       "whole": true,
         *       "course": [
         *         [
         *           4,
         *           0.0215
         *         ],
         *         [
         *           12,
         *           17.8066
         *         ],
         *         [
         *           20,
         *           18.286
         *         ]
         *       ],
         *       "stretches": [
         *         {
         *           "limited_by": "motion",
         *           "first_line": 4,
         *           "last_line": 2011,
         *           "start_s": 0.0215,
         *           "duration_s": 142.6239
         *         }
         *       ],
         *       "stretch_count": 1,
         *       "lowest_buffer_bytes": 0,
         *       "lowest_buffer_blocks": 0,
         *       "without_stall": {
         *         "feed_share": null,
         *         "feed_mm_min": null,
         *         "baud": null,
         *         "standard_baud": null
         *       },
         *       "validated": true
         *     }
         */
        TimingFigures: {
            /** @description that ran */
            blocks: number;
            /** @description of the whole program */
            cycle_s: number;
            /** @description of motion alone */
            motion_s: number;
            /** @description of the control's computing alone */
            compute_s: number;
            /** @description of the line alone */
            line_s: number;
            /** @description standstills while the control waits for blocks */
            stalls: number;
            /** @description how much longer the program takes because of them */
            stall_s: number;
            /** @description of the program; 0: none */
            first_stall_line: number;
            /** @description compute_s may be as little, as far as the cost model is known */
            compute_low_s: number;
            /** @description and as much */
            compute_high_s: number;
            /**
             * @description of the cost model; calibrated: at this machine
             * @enum {string}
             */
            compute_source: "assumed" | "paper" | "calibrated";
            /** @description of the cost model, in words */
            compute_origin: string;
            /** @description all standstills together */
            standstill_s: number;
            /** @description since the start */
            first_stall_at_s: number;
            /** @description of all */
            longest_standstill_s: number;
            /** @description of the program; 0: none */
            longest_standstill_line: number;
            /** @description since the start */
            first_move_s: number;
            /** @description of rapid motion */
            rapid_s: number;
            /** @description of all motion */
            path_mm: number;
            /** @description on average */
            blocks_per_s: number;
            /** @description how long each was what the machine waited for, in seconds */
            limited_s: {
                /** @description in seconds */
                motion: number;
                /** @description in seconds */
                compute: number;
                /** @description in seconds */
                line: number;
                /** @description in seconds */
                buffer: number;
            };
            /** @description the times are those of the whole program, not of its beginning */
            whole: boolean;
            /** @description some lines in their order; empty where lines run more than once */
            course: number[][];
            /** @description the first ones, in their order */
            stretches: {
                /**
                 * @description what they wait for
                 * @enum {string}
                 */
                limited_by: "motion" | "compute" | "line" | "buffer";
                /** @description of the program */
                first_line: number;
                /** @description of the program */
                last_line: number;
                /** @description since the start */
                start_s: number;
                /** @description of all of them */
                duration_s: number;
            }[];
            /** @description how many there are in all */
            stretch_count: number;
            /** @description in the control; null: it is not fed over a line */
            lowest_buffer_bytes: number | null;
            /** @description in the control; null: it is not fed over a line */
            lowest_buffer_blocks: number | null;
            /** @description what would let the program run without a standstill; null: not needed, or nothing would */
            without_stall: {
                /** @description of the programmed feed, 0 to 1 */
                feed_share: number | null;
                /** @description the highest programmed feed */
                feed_mm_min: number | null;
                /** @description of the line */
                baud: number | null;
                /** @description the next usual one */
                standard_baud: number | null;
            };
            /** @description the text was validated before it ran */
            validated: boolean;
        };
        /**
         * @description for which values a family passes
         * @example {
         *       "parameters": [
         *         {
         *           "name": "chord_error",
         *           "unit": "mm",
         *           "low": 0.0001,
         *           "high": 0.5,
         *           "standard": 0.002,
         *           "passes": [
         *             0.0001,
         *             0.5
         *           ],
         *           "low_bound": null,
         *           "high_bound": null
         *         },
         *         {
         *           "name": "speed_rpm",
         *           "unit": "rpm",
         *           "low": 10,
         *           "high": 2500,
         *           "standard": 500,
         *           "passes": [
         *             10,
         *             2500
         *           ],
         *           "low_bound": null,
         *           "high_bound": null
         *         }
         *       ],
         *       "standard": {
         *         "passes": true,
         *         "check": "",
         *         "text": ""
         *       },
         *       "corners": {
         *         "tried": 4,
         *         "passed": 4
         *       },
         *       "samples": {
         *         "tried": 0,
         *         "passed": 0
         *       },
         *       "smallest_failure": null,
         *       "trials": 9
         *     }
         */
        SweepFigures: {
            /** @description in the family's order */
            parameters: {
                /** @description of the parameter */
                name: string;
                /** @description of its values; empty: a plain number */
                unit: string;
                /** @description end of its range */
                low: number;
                /** @description end of its range */
                high: number;
                /** @description from which it is moved */
                standard: number;
                /** @description least and greatest value that passes, to the precision of the bisection */
                passes?: number[];
                /** @description what fails below; null: the range ends there */
                low_bound?: {
                    /** @description nearest value that fails, in the parameter's unit */
                    fails_at: number;
                    /** @description that fails there */
                    check: string;
                    /** @description its text */
                    text: string;
                } | null;
                /** @description what fails above; null: the range ends there */
                high_bound?: {
                    /** @description nearest value that fails, in the parameter's unit */
                    fails_at: number;
                    /** @description that fails there */
                    check: string;
                    /** @description its text */
                    text: string;
                } | null;
            }[];
            /** @description the result for a set of values */
            standard: {
                /** @description all checks */
                passes: boolean;
                /** @description that fails; empty: none */
                check: string;
                /** @description its text; empty: none */
                text: string;
            };
            /** @description all parameters at an end of their range */
            corners: {
                /** @description sets of values */
                tried: number;
                /** @description of these */
                passed: number;
            };
            /** @description values drawn at random */
            samples: {
                /** @description sets of values */
                tried: number;
                /** @description of these */
                passed: number;
            };
            /** @description the values nearest to the standard that fail; null: none was found */
            smallest_failure: {
                /** @description false */
                passes: boolean;
                /** @description that fails */
                check: string;
                /** @description its text */
                text: string;
                /** @description by parameter */
                values: {
                    [key: string]: number;
                };
                /** @description that differ from the standard */
                changed: string[];
            } | null;
            /** @description programs that were rendered and checked */
            trials: number;
        };
        /**
         * @description heavy work that waits for a worker process or runs in one
         * @example {
         *       "id": 55,
         *       "kind": "check",
         *       "subject": "program/7",
         *       "machine": "lathe",
         *       "actor": "the programmer",
         *       "state": "running",
         *       "place": null,
         *       "waiting_since_ms": 1795879519557,
         *       "running_since_ms": 1795879519557,
         *       "budget_s": 60
         *     }
         */
        Work: {
            /** @description since the server's start */
            id: number;
            /** @description check, render, accuracy, gouge, timing or sweep */
            kind: string;
            /** @description the program or family */
            subject: string;
            /** @description that it is done for; empty: none */
            machine: string;
            /** @description who asked for it */
            actor: string;
            /**
             * @description of the work
             * @enum {string}
             */
            state: "waiting" | "running";
            /** @description in the queue, from 1; null: it runs */
            place: number | null;
            /** @description when it was asked for; milliseconds since 1970, UTC */
            waiting_since_ms: number;
            /** @description when its process began; milliseconds since 1970, UTC */
            running_since_ms: number | null;
            /** @description of its process; null: not known yet */
            budget_s: number | null;
        };
        /**
         * @description a text that may go to one machine by one delivery
         * @example {
         *       "id": 17,
         *       "state": "approved",
         *       "program": 77,
         *       "revision": 1,
         *       "machine": "lathe-1",
         *       "delivery": "drip",
         *       "sha256": "9f2c4e0b8a6d1f3579bd02468ace13579bdf02468ace13579bdf02468ace1357",
         *       "restart": null,
         *       "transfers_allowed": 3,
         *       "transfers_done": 1,
         *       "proved_by": "olga",
         *       "proof": "first part measured, all sizes in the middle",
         *       "created_by": "paula",
         *       "created_at_ms": 1795500300000,
         *       "approved_by": "anna",
         *       "sign_off": "first part measured",
         *       "changed_at_ms": 1795507200000
         *     }
         */
        Release: {
            /** @description of the release */
            id: number;
            /**
             * @description of the release
             * @enum {string}
             */
            state: "draft" | "in_review" | "proving" | "approved" | "obsolete";
            /** @description its id */
            program: number;
            /** @description of the program's text */
            revision: number;
            /** @description to which it may go */
            machine: string;
            /**
             * @description how the text is sent to the control
             * @enum {string}
             */
            delivery: "drip" | "memory";
            /** @description of the text, in hexadecimal */
            sha256: string;
            /** @description the restart of another release's text; null: it is none */
            restart: {
                /** @description whose text it continues */
                release: number;
                /** @description of that text, where it begins */
                line: number;
            } | null;
            /** @description while it is proved */
            transfers_allowed: number;
            /** @description of these */
            transfers_done: number;
            /** @description the operator who signed the proving off; null: no one yet */
            proved_by: string | null;
            /** @description what they wrote */
            proof: string | null;
            /** @description who made it */
            created_by: string;
            /** @description when it was made; milliseconds since 1970, UTC */
            created_at_ms: number;
            /** @description who approved it */
            approved_by: string | null;
            /** @description what they wrote */
            sign_off: string | null;
            /** @description when its state changed last; milliseconds since 1970, UTC */
            changed_at_ms: number;
        };
        /**
         * @description the restart of a program at a line, as it would be sent
         * @example {
         *       "possible": true,
         *       "text": "%\nO0042\n(RESTART AT LINE 8)\nG21\nG18 G99 G40\nG28 U0.\nG28 W0.\nG55\nT0101\nG97 S500 M03\nG00 X100.\nG00 Z10.\nG01 X50.000 Z0.000 F0.2\nG01 X50.100 Z-0.050 F0.2\nG01 X50.200 Z-0.100 F0.2\nG01 X50.300 Z-0.150 F0.2\nG01 X50.400 Z-0.200 F0.2\nG01 X50.500 Z-0.250 F0.2\nG01 X50.600 Z-0.300 F0.2\nG01 X50.000 Z-0.350 F0.2",
         *       "sha256": "8dcd2a66871ee5b2fcc687800337be684cc4e5dc400b6f4ac24fde778d46051f",
         *       "preamble_line": 3,
         *       "rest_line": 13,
         *       "assumptions": [
         *         "The control is reset, and the tool stands clear of the work, its fixture and the machine.",
         *         "All that stands before line 8 is done, and the work has not been moved since; work offsets and the lengths and radii of tools are those of the first run.",
         *         "X and then Z can go to the reference point from where the tool stands, and the tool is changed there."
         *       ],
         *       "compared_moves": 2002,
         *       "findings": [],
         *       "not_held": "the part is not known",
         *       "safe_before": null,
         *       "safe_after": null,
         *       "diagnostics": []
         *     }
         */
        RestartPreview: {
            /** @description a text could be made, and nothing found forbids to send it */
            possible: boolean;
            /** @description the whole text; null: it is refused */
            text: string | null;
            /** @description of the text, in hexadecimal: what is approved */
            sha256: string | null;
            /** @description of the text, where what is new begins */
            preamble_line: number | null;
            /** @description of the text, where the rest of the program begins */
            rest_line: number | null;
            /** @description what must hold at the machine */
            assumptions: string[];
            /** @description of the rest, that are those of the whole program */
            compared_moves: number;
            /** @description of the part as the blocks before the line have left it */
            findings: {
                /**
                 * @description how bad it is
                 * @enum {string}
                 */
                severity: "note" | "warning" | "error";
                /** @description of the text */
                line: number;
                /** @description one sentence */
                text: string;
            }[];
            /** @description why the moves were not compared with the part; null: they were */
            not_held: string | null;
            /** @description nearest line before it where a restart is possible; null: none was looked for, or found */
            safe_before: number | null;
            /** @description the same after it */
            safe_after: number | null;
            /** @description why it is refused */
            diagnostics: {
                /** @description of the kind of fault */
                id: string;
                /**
                 * @description how bad it is
                 * @enum {string}
                 */
                severity: "note" | "warning" | "error";
                /** @description the called program that it is in; null: the text itself */
                file: string | null;
                /** @description from 1 */
                line: number;
                /** @description from 1, in bytes */
                column: number;
                /** @description from 1, in characters */
                column_chars: number;
                /** @description one sentence */
                text: string;
                /** @description by which the control itself would name it */
                alarm: string | null;
            }[];
        };
        /**
         * @description one transfer of a released text to a machine
         * @example {
         *       "id": 412,
         *       "state": "feeding",
         *       "machine": "lathe-1",
         *       "release": 17,
         *       "order": 31,
         *       "restart": null,
         *       "program": 77,
         *       "revision": 1,
         *       "sha256": "9f2c4e0b8a6d1f3579bd02468ace13579bdf02468ace13579bdf02468ace1357",
         *       "delivery": "drip",
         *       "link": "tcp://10.0.0.21:4001",
         *       "bytes": 24,
         *       "reason": "",
         *       "reason_id": null,
         *       "reason_said": null,
         *       "rank": 1,
         *       "created_by": "the MES",
         *       "created_at_ms": 1795500400000,
         *       "armed_by": "olga",
         *       "armed_at_ms": 1795500500000,
         *       "expires_at_ms": 1795501100000,
         *       "started_at_ms": 1795500512000,
         *       "ended_at_ms": null,
         *       "held_s": null,
         *       "holds": null,
         *       "line_s": null,
         *       "forecast_s": 38.4,
         *       "torn": false,
         *       "not_before_ms": null,
         *       "on_hold": null,
         *       "retry_of": null,
         *       "choice": null,
         *       "end_check": "part taken out",
         *       "needs_end_confirmation": false,
         *       "end_confirmed_by": null,
         *       "end_confirmed_at_ms": null,
         *       "end_note": null,
         *       "needs_confirmation": false,
         *       "confirmed_by": null,
         *       "confirm_reason": null,
         *       "read_back": null,
         *       "read_back_state": null
         *     }
         */
        Job: {
            /** @description of the job */
            id: number;
            /**
             * @description of the job
             * @enum {string}
             */
            state: "queued" | "armed" | "feeding" | "held" | "draining" | "done" | "failed" | "cancelled" | "interrupted";
            /** @description to which it is sent */
            machine: string;
            /** @description its id */
            release: number;
            /** @description that it belongs to; null: none */
            order: number | null;
            /** @description the restart of another release's text; null: it is none */
            restart: {
                /** @description whose text it continues */
                release: number;
                /** @description of that text, where it begins */
                line: number;
            } | null;
            /** @description its id */
            program: number;
            /** @description of the program's text */
            revision: number;
            /** @description of the text, in hexadecimal */
            sha256: string;
            /**
             * @description how the text is sent to the control
             * @enum {string}
             */
            delivery: "drip" | "memory";
            /** @description URL of the line */
            link: string;
            /** @description of the transfer on the wire; 0: not known yet */
            bytes: number;
            /** @description of the last change of its state; empty: none */
            reason: string;
            /** @description the same as one word or the name of a stall; null: there is none */
            reason_id: string | null;
            reason_said: components["schemas"]["Said"] | null;
            /** @description queued jobs of a machine go in this order, equal ones by id */
            rank: number;
            /** @description who made it */
            created_by: string;
            /** @description when it was made; milliseconds since 1970, UTC */
            created_at_ms: number;
            /** @description who armed it last */
            armed_by: string | null;
            /** @description when it was armed last; milliseconds since 1970, UTC */
            armed_at_ms: number | null;
            /** @description when its arming ends, while it is armed; milliseconds since 1970, UTC */
            expires_at_ms: number | null;
            /** @description when it first fed; milliseconds since 1970, UTC */
            started_at_ms: number | null;
            /** @description when it ended; milliseconds since 1970, UTC */
            ended_at_ms: number | null;
            /** @description it broke off inside a block: the control may hold a part of it */
            torn: boolean;
            /** @description it is torn, and no person has confirmed yet that the control was reset */
            needs_confirmation: boolean;
            /** @description who confirmed that the control was reset */
            confirmed_by: string | null;
            /** @description what they wrote */
            confirm_reason: string | null;
            /** @description the result of reading the program back from the control */
            read_back: string | null;
            /**
             * @description the same as one word
             * @enum {string|null}
             */
            read_back_state: "waiting" | "equal" | "differs" | "expired" | "superseded" | null;
            /** @description that its control held, in seconds; null: not counted, or not over */
            held_s: number | null;
            /** @description how often its control held; null: not counted, or not over */
            holds: number | null;
            /** @description that its characters took on the line, in seconds; null: not counted, or not over */
            line_s: number | null;
            /** @description of a drip feed, how long its check expected it to take, when it was armed; null: not known */
            forecast_s: number | null;
            /** @description before which it is armed only with a reason; null: at any time; milliseconds since 1970, UTC */
            not_before_ms: number | null;
            /** @description a queued job on hold is not armed; null: it is not on hold */
            on_hold: {
                /** @description who put it on hold */
                by: string;
                /** @description what they wrote */
                reason: string;
            } | null;
            /** @description the job that ended, of which it is another transfer; null: none */
            retry_of: number | null;
            /** @description of which one job is armed; null: it stands alone */
            choice: number | null;
            /** @description what a person confirms after its end, before the next job of its machine is armed */
            end_check: string | null;
            /** @description it has ended, and no person has confirmed `end_check` yet */
            needs_end_confirmation: boolean;
            /** @description who confirmed it */
            end_confirmed_by: string | null;
            /** @description when; milliseconds since 1970, UTC */
            end_confirmed_at_ms: number | null;
            /** @description what they wrote */
            end_note: string | null;
        };
        /**
         * @description how long a job's program takes by its check; nothing here was seen at the machine
         * @example {
         *       "job": 1,
         *       "verdict": 1,
         *       "stale": false,
         *       "cycle_s": 21.5025,
         *       "course": [
         *         [
         *           4,
         *           0.0215
         *         ],
         *         [
         *           5,
         *           0.0235
         *         ],
         *         [
         *           6,
         *           1.5235
         *         ]
         *       ],
         *       "buffer_bytes": 2048,
         *       "buffer_blocks": null
         *     }
         */
        JobForecast: {
            /** @description its id */
            job: number;
            /** @description that has the times; null: it was not checked */
            verdict: number | null;
            /** @description as of the verdict */
            stale: boolean;
            /** @description of the whole program, in seconds; null: not known */
            cycle_s: number | null;
            /** @description some lines in their order; empty where nothing is known of them */
            course: number[][];
            /** @description that the control holds; null: not known, or not limited so */
            buffer_bytes: number | null;
            /** @description that the control holds; null: not known, or not limited so */
            buffer_blocks: number | null;
        };
        /**
         * @description a program that is queued for several machines: one of the jobs is armed, the others leave the queue then
         * @example {
         *       "choice": 1,
         *       "jobs": [
         *         {
         *           "id": 1,
         *           "state": "queued",
         *           "machine": "lathe",
         *           "release": 1,
         *           "order": 1,
         *           "restart": null,
         *           "program": 1,
         *           "revision": 1,
         *           "sha256": "2f8a65ba79af81222c550f3d60fc7743f38a6972664a5d49ecaf9f075e153f63",
         *           "delivery": "drip",
         *           "link": "tcp://10.0.0.21:4001",
         *           "bytes": 3831,
         *           "reason": "",
         *           "reason_id": null,
         *           "reason_said": null,
         *           "rank": 1,
         *           "created_by": "the operator",
         *           "created_at_ms": 1795879534584,
         *           "armed_by": null,
         *           "armed_at_ms": null,
         *           "expires_at_ms": null,
         *           "started_at_ms": null,
         *           "ended_at_ms": null,
         *           "torn": false,
         *           "needs_confirmation": false,
         *           "confirmed_by": null,
         *           "confirm_reason": null,
         *           "read_back": null,
         *           "read_back_state": null,
         *           "held_s": null,
         *           "holds": null,
         *           "line_s": null,
         *           "forecast_s": null,
         *           "not_before_ms": null,
         *           "on_hold": null,
         *           "retry_of": null,
         *           "choice": 1,
         *           "end_check": "part taken out",
         *           "needs_end_confirmation": false,
         *           "end_confirmed_by": null,
         *           "end_confirmed_at_ms": null,
         *           "end_note": null
         *         },
         *         {
         *           "id": 2,
         *           "state": "queued",
         *           "machine": "second",
         *           "release": 2,
         *           "order": 1,
         *           "restart": null,
         *           "program": 1,
         *           "revision": 1,
         *           "sha256": "2f8a65ba79af81222c550f3d60fc7743f38a6972664a5d49ecaf9f075e153f63",
         *           "delivery": "drip",
         *           "link": "tcp://10.0.0.21:4001",
         *           "bytes": 3831,
         *           "reason": "",
         *           "reason_id": null,
         *           "reason_said": null,
         *           "rank": 1,
         *           "created_by": "the operator",
         *           "created_at_ms": 1795879534584,
         *           "armed_by": null,
         *           "armed_at_ms": null,
         *           "expires_at_ms": null,
         *           "started_at_ms": null,
         *           "ended_at_ms": null,
         *           "torn": false,
         *           "needs_confirmation": false,
         *           "confirmed_by": null,
         *           "confirm_reason": null,
         *           "read_back": null,
         *           "read_back_state": null,
         *           "held_s": null,
         *           "holds": null,
         *           "line_s": null,
         *           "forecast_s": null,
         *           "not_before_ms": null,
         *           "on_hold": null,
         *           "retry_of": null,
         *           "choice": 1,
         *           "end_check": "part taken out",
         *           "needs_end_confirmation": false,
         *           "end_confirmed_by": null,
         *           "end_confirmed_at_ms": null,
         *           "end_note": null
         *         }
         *       ],
         *       "left_out": [
         *         {
         *           "machine": "third",
         *           "why": "no release lets this text go to this machine (text 2f8a65ba79af81222c550f3d60fc7743f38a6972664a5d49ecaf9f075e153f63 on third)"
         *         }
         *       ]
         *     }
         */
        JobChoice: {
            /** @description id of the first of its jobs, by which they belong together */
            choice: number;
            /** @description one a machine */
            jobs: components["schemas"]["Job"][];
            /** @description by machine */
            left_out: {
                /** @description its name */
                machine: string;
                /** @description one sentence */
                why: string;
            }[];
        };
        /**
         * @description what is known of a transfer
         * @example {
         *       "items": [
         *         {
         *           "seq": 28,
         *           "at_ms": 1795879552858,
         *           "handed": 3830,
         *           "clocked": 2798,
         *           "confirmed": 0,
         *           "reserve": 3831,
         *           "note": ""
         *         },
         *         {
         *           "seq": 29,
         *           "at_ms": 1795879552863,
         *           "handed": 3831,
         *           "clocked": 2807,
         *           "confirmed": 0,
         *           "reserve": 3831,
         *           "note": "waiting for end"
         *         },
         *         {
         *           "seq": 30,
         *           "at_ms": 1795879552971,
         *           "handed": 3831,
         *           "clocked": 2924,
         *           "confirmed": 0,
         *           "reserve": 3831,
         *           "note": ""
         *         }
         *       ],
         *       "next": "30",
         *       "interval": {
         *         "low": 3831,
         *         "high": 3831,
         *         "known": "clocked"
         *       }
         *     }
         */
        Ledger: {
            /** @description in the order of writing */
            items: {
                /** @description of the row, from 1 */
                seq: number;
                /** @description when it was written; milliseconds since 1970, UTC */
                at_ms: number;
                /** @description given to the system's port */
                handed: number;
                /** @description that have left, by line time */
                clocked: number;
                /** @description that the protocol acknowledged */
                confirmed: number;
                /** @description the feed hands nothing beyond it before the next row is written */
                reserve: number;
                /** @description what happened; empty: nothing but progress */
                note: string;
            }[];
            /** @description for `after` of the next page; null: this is the last */
            next: string | null;
            /** @description how much the control has, in bytes on the wire */
            interval: {
                /** @description at least */
                low: number;
                /** @description at most */
                high: number;
                /**
                 * @description by what `low` is known
                 * @enum {string}
                 */
                known: "clocked" | "confirmed";
            };
        };
        /**
         * @example {
         *       "id": 1,
         *       "state": "failed",
         *       "machine": "lathe",
         *       "release": 1,
         *       "order": null,
         *       "restart": null,
         *       "program": 1,
         *       "revision": 1,
         *       "sha256": "2f8a65ba79af81222c550f3d60fc7743f38a6972664a5d49ecaf9f075e153f63",
         *       "delivery": "drip",
         *       "link": "tcp://10.0.0.21:4001",
         *       "bytes": 3831,
         *       "reason": "link_lost: between wire byte 0 and 29 of 3831 may have reached the control (line 1 to 5); a block is torn: reset the control and confirm it; Connection reset by peer",
         *       "reason_id": "link_lost",
         *       "reason_said": {
         *         "id": "reached_torn_because_lines",
         *         "values": {
         *           "cause": {
         *             "text": "link_lost",
         *             "said": null
         *           },
         *           "from": {
         *             "text": "0",
         *             "said": null
         *           },
         *           "to": {
         *             "text": "29",
         *             "said": null
         *           },
         *           "total": {
         *             "text": "3831",
         *             "said": null
         *           },
         *           "first": {
         *             "text": "1",
         *             "said": null
         *           },
         *           "last": {
         *             "text": "5",
         *             "said": null
         *           },
         *           "why": {
         *             "text": "Connection reset by peer",
         *             "said": null
         *           }
         *         }
         *       },
         *       "rank": 1,
         *       "created_by": "admin",
         *       "created_at_ms": 1795879628314,
         *       "armed_by": "admin",
         *       "armed_at_ms": 1795879628364,
         *       "expires_at_ms": null,
         *       "started_at_ms": 1795879628381,
         *       "ended_at_ms": 1795879628549,
         *       "torn": true,
         *       "needs_confirmation": true,
         *       "confirmed_by": null,
         *       "confirm_reason": null,
         *       "read_back": null,
         *       "read_back_state": null,
         *       "held_s": 0.15,
         *       "holds": 1,
         *       "line_s": 0,
         *       "forecast_s": 27.142,
         *       "not_before_ms": null,
         *       "on_hold": null,
         *       "retry_of": null,
         *       "choice": null,
         *       "end_check": null,
         *       "needs_end_confirmation": false,
         *       "end_confirmed_by": null,
         *       "end_confirmed_at_ms": null,
         *       "end_note": null
         *     }
         */
        EventJob: components["schemas"]["Job"];
        /**
         * @description sums of the transfers that ended in a time
         * @example {
         *       "by": "part",
         *       "all": {
         *         "jobs": 4,
         *         "done": 2,
         *         "failed": 0,
         *         "cancelled": 2,
         *         "interrupted": 0,
         *         "bytes": 20562,
         *         "fed": 3,
         *         "held_jobs": 3,
         *         "holds_jobs": 3,
         *         "holds": 2,
         *         "line_jobs": 3,
         *         "forecast_jobs": 2,
         *         "feeding_s": 12.301,
         *         "held_s": 0.699,
         *         "line_s": 10.958,
         *         "line_free_s": 11.602,
         *         "forecast_s": 85.582,
         *         "forecast_took_s": 11.889,
         *         "line_use": 0.9445
         *       },
         *       "groups": [
         *         {
         *           "name": "",
         *           "from_ms": null,
         *           "to_ms": null,
         *           "jobs": 2,
         *           "done": 1,
         *           "failed": 0,
         *           "cancelled": 1,
         *           "interrupted": 0,
         *           "bytes": 10281,
         *           "fed": 1,
         *           "held_jobs": 1,
         *           "holds_jobs": 1,
         *           "holds": 1,
         *           "line_jobs": 1,
         *           "forecast_jobs": 1,
         *           "feeding_s": 6.118,
         *           "held_s": 0.339,
         *           "line_s": 5.463,
         *           "line_free_s": 5.779,
         *           "forecast_s": 42.791,
         *           "forecast_took_s": 6.118,
         *           "line_use": 0.9453
         *         },
         *         {
         *           "name": "=R,1",
         *           "from_ms": null,
         *           "to_ms": null,
         *           "jobs": 2,
         *           "done": 1,
         *           "failed": 0,
         *           "cancelled": 1,
         *           "interrupted": 0,
         *           "bytes": 10281,
         *           "fed": 2,
         *           "held_jobs": 2,
         *           "holds_jobs": 2,
         *           "holds": 1,
         *           "line_jobs": 2,
         *           "forecast_jobs": 1,
         *           "feeding_s": 6.183,
         *           "held_s": 0.36,
         *           "line_s": 5.495,
         *           "line_free_s": 5.823,
         *           "forecast_s": 42.791,
         *           "forecast_took_s": 5.771,
         *           "line_use": 0.9437
         *         }
         *       ]
         *     }
         */
        HistorySums: {
            /**
             * @description what they are grouped by
             * @enum {string}
             */
            by: "machine" | "part" | "day" | "shift";
            /** @description of all groups */
            all: {
                /** @description transfers that ended */
                jobs: number;
                /** @description of these */
                done: number;
                /** @description of these */
                failed: number;
                /** @description of these */
                cancelled: number;
                /** @description of these */
                interrupted: number;
                /** @description on the wire, of those that are done */
                bytes: number;
                /** @description transfers of which something was sent */
                fed: number;
                /** @description transfers whose holds were timed: `held_s` is of these */
                held_jobs: number;
                /** @description transfers whose holds were counted: `holds` is of these */
                holds_jobs: number;
                /** @description by the controls */
                holds: number;
                /** @description transfers whose characters were timed: `line_s` is of these */
                line_jobs: number;
                /** @description transfers that are done and had a forecast: `forecast_s` and `forecast_took_s` are of these */
                forecast_jobs: number;
                /** @description from the first byte to the end, in seconds */
                feeding_s: number;
                /** @description held by the controls, in seconds */
                held_s: number;
                /** @description that characters took on the lines, in seconds */
                line_s: number;
                /** @description from the first byte to the end without the holds, of the same transfers, in seconds */
                line_free_s: number;
                /** @description that the checks expected, in seconds */
                forecast_s: number;
                /** @description from the first byte to the end, of the same transfers, in seconds */
                forecast_took_s: number;
                /** @description `line_s` of `line_free_s`; null: nothing was timed */
                line_use: number | null;
            };
            /** @description machines and parts by name; days and shifts newest first */
            groups: {
                /** @description of the machine; number of the part, empty: not known; the day, or day and start of the shift, by the server's clock */
                name: string;
                /** @description start of the day or shift; milliseconds since 1970, UTC */
                from_ms: number | null;
                /** @description its end; milliseconds since 1970, UTC */
                to_ms: number | null;
                /** @description transfers that ended */
                jobs: number;
                /** @description of these */
                done: number;
                /** @description of these */
                failed: number;
                /** @description of these */
                cancelled: number;
                /** @description of these */
                interrupted: number;
                /** @description on the wire, of those that are done */
                bytes: number;
                /** @description transfers of which something was sent */
                fed: number;
                /** @description transfers whose holds were timed: `held_s` is of these */
                held_jobs: number;
                /** @description transfers whose holds were counted: `holds` is of these */
                holds_jobs: number;
                /** @description by the controls */
                holds: number;
                /** @description transfers whose characters were timed: `line_s` is of these */
                line_jobs: number;
                /** @description transfers that are done and had a forecast: `forecast_s` and `forecast_took_s` are of these */
                forecast_jobs: number;
                /** @description from the first byte to the end, in seconds */
                feeding_s: number;
                /** @description held by the controls, in seconds */
                held_s: number;
                /** @description that characters took on the lines, in seconds */
                line_s: number;
                /** @description from the first byte to the end without the holds, of the same transfers, in seconds */
                line_free_s: number;
                /** @description that the checks expected, in seconds */
                forecast_s: number;
                /** @description from the first byte to the end, of the same transfers, in seconds */
                forecast_took_s: number;
                /** @description `line_s` of `line_free_s`; null: nothing was timed */
                line_use: number | null;
            }[];
        };
        /**
         * @description why a transfer stood still or broke off, as a person stated it
         * @example {
         *       "job": 1,
         *       "reason": "tool broken",
         *       "note": "insert of T3",
         *       "by": "the operator",
         *       "at_ms": 1795879575591
         *     }
         */
        StopReason: {
            /** @description its id */
            job: number;
            /** @description of the shop's list of that time */
            reason: string;
            /** @description what they wrote; empty: nothing */
            note: string;
            /** @description who stated it */
            by: string;
            /** @description when; milliseconds since 1970, UTC */
            at_ms: number;
        };
        /**
         * @description what people stated of a job
         * @example {
         *       "reasons": [
         *         {
         *           "job": 2,
         *           "reason": "tool change",
         *           "note": "",
         *           "by": "the operator",
         *           "at_ms": 1795880052504
         *         },
         *         {
         *           "job": 2,
         *           "reason": "tool broken",
         *           "note": "insert: T3, second edge",
         *           "by": "the operator",
         *           "at_ms": 1795880052464
         *         }
         *       ]
         *     }
         */
        JobStopReasons: {
            /** @description newest first, 1000 at most */
            reasons: components["schemas"]["StopReason"][];
        };
        /**
         * @description which reasons there are, and how often each was stated
         * @example {
         *       "offered": [
         *         "tool broken",
         *         "tool change",
         *         "material missing"
         *       ],
         *       "counts": [
         *         {
         *           "machine": "lathe",
         *           "reason": "tool change",
         *           "count": 2
         *         },
         *         {
         *           "machine": "lathe",
         *           "reason": "tool broken",
         *           "count": 1
         *         }
         *       ]
         *     }
         */
        StopReasonCounts: {
            /** @description that people choose from; --stop-reason */
            offered: string[];
            /** @description in the time that is asked for, the most frequent first */
            counts: {
                /** @description its name */
                machine: string;
                /** @description of the list of that time */
                reason: string;
                /** @description how often it was stated */
                count: number;
            }[];
        };
        /**
         * @description a program that a control punched
         * @example {
         *       "id": 4,
         *       "machine": "lathe",
         *       "at_ms": 1795879620539,
         *       "name": "O9",
         *       "named_by": "number",
         *       "state": "accepted",
         *       "reason": "characters have wrong parity (2, the first at byte 5)",
         *       "sha256": "8e539c21a2115c6f0c04b2446603d875fd2de00719fd8d3cdbe9c1fbc790697e",
         *       "bytes": 11,
         *       "raw_bytes": 11,
         *       "code": "iso",
         *       "ended_by": "punch_off",
         *       "stored": null,
         *       "program": 2,
         *       "revision": 1,
         *       "decided_by": "the approver",
         *       "decided_reason": "only its end is missing",
         *       "decided_at_ms": 1795879620569
         *     }
         */
        Receipt: {
            /** @description of the receipt */
            id: number;
            /** @description whose control punched it */
            machine: string;
            /** @description when it ended; milliseconds since 1970, UTC */
            at_ms: number;
            /** @description as the program names itself, or by its time */
            name: string;
            /**
             * @description where the name was found
             * @enum {string}
             */
            named_by: "okuma" | "sinumerik" | "fagor" | "heidenhain" | "header" | "number" | "angle" | "comment" | "time";
            /**
             * @description of the receipt
             * @enum {string}
             */
            state: "stored" | "quarantined" | "accepted" | "discarded";
            /** @description why it is in quarantine */
            reason: string | null;
            /** @description of what is kept, in hexadecimal */
            sha256: string;
            /** @description of what is kept */
            bytes: number;
            /** @description as they came on the wire */
            raw_bytes: number;
            /**
             * @description in which it came
             * @enum {string}
             */
            code: "ascii" | "iso" | "eia";
            /**
             * @description the sign that ended it
             * @enum {string}
             */
            ended_by: "punch_off" | "percent" | "end_code" | "quiet" | "reader_on" | "reset" | "link_lost" | "too_long" | "renewed";
            /** @description the stored program of the same name; null: none, or the receipt is decided */
            stored: {
                /** @description its id */
                program: number;
                /** @description of its text, the newest */
                revision: number;
                /** @description the texts are equal */
                same: boolean;
                /** @description the first one, as a sentence */
                difference: string | null;
            } | null;
            /** @description that it became */
            program: number | null;
            /** @description of that program */
            revision: number | null;
            /** @description who accepted or discarded it */
            decided_by: string | null;
            /** @description what they wrote */
            decided_reason: string | null;
            /** @description when; milliseconds since 1970, UTC */
            decided_at_ms: number | null;
        };
        /**
         * @description which values of a part make its family give a received text
         * @example {
         *       "explains_all": false,
         *       "why_not": "no number differs from the stored program",
         *       "values": [],
         *       "rest": [],
         *       "program": 1,
         *       "revision": 1,
         *       "family": "hyperbolic-roll",
         *       "part": "R-1",
         *       "part_revision": 2
         *     }
         */
        ReceivedValues: {
            /** @description id of the stored program of the same name */
            program: number;
            /** @description of its text, the newest */
            revision: number;
            /** @description from which that was rendered */
            family: string;
            /** @description whose values it has; null: of none */
            part: string | null;
            /** @description of the part's values */
            part_revision: number | null;
            /** @description rendered with these values, every number is the received one */
            explains_all: boolean;
            /** @description why not; null: they explain all */
            why_not: string | null;
            /** @description in the family's order */
            values: {
                /** @description of the parameter */
                name: string;
                /** @description with its unit */
                before: string;
                /** @description with its unit */
                after: string;
            }[];
            /** @description 20 at most */
            rest: {
                /** @description of the received text */
                line: number;
                /** @description the line there */
                stored: string;
                /** @description the line */
                received: string;
            }[];
        };
        /**
         * @description what an operator asked for at the control
         * @example {
         *       "id": 8,
         *       "machine": "lathe",
         *       "at_ms": 1795879625020,
         *       "verb": "load",
         *       "argument": "42",
         *       "text": "%\nO9999(LOAD 42)\n%\n",
         *       "outcome": "armed",
         *       "detail": "O0042 as job 3",
         *       "job": 3
         *     }
         */
        OperatorRequest: {
            /** @description of the request */
            id: number;
            /** @description where it was asked */
            machine: string;
            /** @description when; milliseconds since 1970, UTC */
            at_ms: number;
            /** @description load, drip, dir, save, cancel, status, restart, call; of a doorbell also "request 9" */
            verb: string;
            /** @description of the verb; empty: none */
            argument: string;
            /** @description as the operator wrote it */
            text: string;
            /**
             * @description the result
             * @enum {string}
             */
            outcome: "answered" | "queued" | "armed" | "refused" | "stored";
            /** @description for people */
            detail: string;
            /** @description that it made or armed */
            job: number | null;
        };
        /**
         * @description who calls
         * @example {
         *       "name": "paul",
         *       "role": "viewer",
         *       "by": "token",
         *       "scope": [],
         *       "machines": {
         *         "mill": "approver"
         *       }
         *     }
         */
        Session: {
            /** @description of the user, or of a program's token */
            name: string;
            /**
             * @description what the caller may do: each role may do what those before it may
             * @enum {string}
             */
            role: "viewer" | "operator" | "programmer" | "approver" | "admin";
            /**
             * @description what the caller signed in with
             * @enum {string}
             */
            by: "token" | "password" | "pin" | "provider";
            /** @description what it may change; empty: all */
            scope: string[];
            /** @description roles by machine, where they differ from "role" */
            machines: {
                [key: string]: "viewer" | "operator" | "programmer" | "approver" | "admin";
            };
        };
        /**
         * @description an OpenID Connect provider that people may sign in by
         * @example {
         *       "title": "the shop's accounts"
         *     }
         */
        SignInProvider: {
            /** @description its name for people; null: none is configured */
            title: string | null;
        };
        /**
         * @description a sign-in that has begun
         * @example {
         *       "url": "https://login.shop/authorize?response_type=code&client_id=dnc&scope=openid"
         *     }
         */
        ProviderSignIn: {
            /** @description of the provider: the browser opens it */
            url: string;
        };
        /**
         * @description a person
         * @example {
         *       "name": "olga",
         *       "provider": null,
         *       "role": "programmer",
         *       "grants": [],
         *       "has_password": true,
         *       "has_pin": true,
         *       "failures": 0,
         *       "locked_until_ms": null,
         *       "disabled_at_ms": 1795879437507,
         *       "revision": 2,
         *       "created_by": "admin",
         *       "created_at_ms": 1795879435708
         *     }
         */
        User: {
            /** @description with which the person signs in */
            name: string;
            /** @description issuer of the OpenID Connect provider that vouches for the person; null: an account of this shop alone */
            provider: string | null;
            /**
             * @description on machines of no granted group, and for all that belongs to no machine
             * @enum {string}
             */
            role: "viewer" | "operator" | "programmer" | "approver" | "admin";
            /** @description roles by group */
            grants: {
                /** @description its name */
                group: string;
                /**
                 * @description there
                 * @enum {string}
                 */
                role: "viewer" | "operator" | "programmer" | "approver" | "admin";
            }[];
            /** @description may sign in with a password */
            has_password: boolean;
            /** @description may sign in with a PIN */
            has_pin: boolean;
            /** @description refused sign-ins since the last one that was right */
            failures: number;
            /** @description no person can sign in as this user before then; milliseconds since 1970, UTC */
            locked_until_ms: number | null;
            /** @description since then the user may not sign in; milliseconds since 1970, UTC */
            disabled_at_ms: number | null;
            /** @description of the roles */
            revision: number;
            /** @description who added the user */
            created_by: string;
            /** @description when; milliseconds since 1970, UTC */
            created_at_ms: number;
        };
        /**
         * @description a token, without its secret
         * @example {
         *       "id": 13,
         *       "name": "wall",
         *       "role": "viewer",
         *       "user": null,
         *       "scope": [],
         *       "created_by": "admin",
         *       "created_at_ms": 1795879506246,
         *       "expires_at_ms": null,
         *       "revoked_at_ms": null
         *     }
         */
        Token: {
            /** @description of this token */
            id: number;
            /** @description of the person or program that has it */
            name: string;
            /**
             * @description what it may do: each role may do what those before it may
             * @enum {string}
             */
            role: "viewer" | "operator" | "programmer" | "approver" | "admin";
            /** @description whose rights it has, up to its role; null: a program's own */
            user: string | null;
            /** @description what it may change; empty: all that its role may */
            scope: string[];
            /** @description who made it */
            created_by: string;
            /** @description when; milliseconds since 1970, UTC */
            created_at_ms: number;
            /** @description until then; null: it does not end; milliseconds since 1970, UTC */
            expires_at_ms: number | null;
            /** @description since then it is not valid; milliseconds since 1970, UTC */
            revoked_at_ms: number | null;
        };
        /**
         * @description a new token
         * @example {
         *       "id": 6,
         *       "name": "mes",
         *       "role": "operator",
         *       "user": null,
         *       "scope": [
         *         "queue"
         *       ],
         *       "created_by": "admin",
         *       "created_at_ms": 1795879446740,
         *       "expires_at_ms": 1795879450740,
         *       "revoked_at_ms": null,
         *       "token": "the-secret-is-shown-once-and-kept-nowhere"
         *     }
         */
        TokenMade: {
            /** @description of this token */
            id: number;
            /** @description of the person or program that has it */
            name: string;
            /**
             * @description what it may do: each role may do what those before it may
             * @enum {string}
             */
            role: "viewer" | "operator" | "programmer" | "approver" | "admin";
            /** @description whose rights it has, up to its role; null: a program's own */
            user: string | null;
            /** @description what it may change; empty: all that its role may */
            scope: string[];
            /** @description who made it */
            created_by: string;
            /** @description when; milliseconds since 1970, UTC */
            created_at_ms: number;
            /** @description until then; null: it does not end; milliseconds since 1970, UTC */
            expires_at_ms: number | null;
            /** @description since then it is not valid; milliseconds since 1970, UTC */
            revoked_at_ms: number | null;
            /** @description the secret; shown this once */
            token: string;
        };
        /**
         * @description machines that belong together; a machine is in one group at most
         * @example {
         *       "name": "lathes",
         *       "machines": [
         *         "lathe",
         *         "second",
         *         "third"
         *       ],
         *       "four_eyes": false,
         *       "operator_sign_off": true
         *     }
         */
        MachineGroup: {
            /** @description of this group */
            name: string;
            /** @description in this group */
            machines: string[];
            /** @description whoever wrote or released a text may not approve it on these machines */
            four_eyes: boolean;
            /** @description a release is approved for these machines after an operator signed its proving off */
            operator_sign_off: boolean;
        };
        /**
         * @description who did what to what, and when; each row holds the hash of the one before
         * @example {
         *       "seq": 39,
         *       "at_ms": 1795879506283,
         *       "actor": "admin",
         *       "action": "token.revoke",
         *       "subject": "token/13",
         *       "detail": "wall",
         *       "previous_hash": "663263f0b25684ca3895d85d0c3a48ebb7970acee75e3c53340682ce01aba4fd",
         *       "hash": "017733a229f635d939071ebbc0929dacea3333a42b1bac3d5fd59915099d1655"
         *     }
         */
        AuditRow: {
            /** @description 1, 2, 3, … */
            seq: number;
            /** @description when; milliseconds since 1970, UTC */
            at_ms: number;
            /** @description who did it */
            actor: string;
            /** @description as "machine.change" */
            action: string;
            /** @description as "machine/mill-3" */
            subject: string;
            /** @description words or a document */
            detail: string;
            /** @description of the row before; empty in the first one */
            previous_hash: string;
            /** @description SHA-256 of all other members */
            hash: string;
        };
        /**
         * @description where the store is and what room it has
         * @example {
         *       "engine": "sqlite",
         *       "folder": "/var/lib/dripfeed",
         *       "bytes": 1327624,
         *       "free_bytes": 60741840896,
         *       "backups": "/mnt/backups",
         *       "backups_free_bytes": 60741840896,
         *       "why_no_backups": null
         *     }
         */
        StoreRoom: {
            /**
             * @description that keeps it
             * @enum {string}
             */
            engine: "sqlite" | "postgresql";
            /** @description of the server, on its computer */
            folder: string;
            /** @description of the store's file; null: it is a database */
            bytes: number | null;
            /** @description of the disk of that folder; null: not known */
            free_bytes: number | null;
            /** @description folder of the backups; null: none are made here */
            backups: string | null;
            /** @description of the disk of the backups; null: not known */
            backups_free_bytes: number | null;
            /** @description why none are made here; null: they are */
            why_no_backups: string | null;
        };
        /**
         * @description the whole store, read through
         * @example {
         *       "whole": true,
         *       "audit": {
         *         "rows": 17,
         *         "head": "097c378bc587f231fdea35f17aaa1d4a084fb308896555148d0380eea1b533ba"
         *       },
         *       "ledger": {
         *         "jobs": 1,
         *         "rows": 9
         *       },
         *       "contents": {
         *         "count": 4,
         *         "bytes": 1666185
         *       },
         *       "torn_machines": 0,
         *       "faults": []
         *     }
         */
        StoreVerification: {
            /** @description no fault was found */
            whole: boolean;
            /** @description its chain */
            audit: {
                /** @description that were read */
                rows: number;
                /** @description hash of the last row; note it elsewhere to notice a cut end */
                head: string;
            };
            /** @description of all transfers */
            ledger: {
                /** @description with rows */
                jobs: number;
                /** @description that were read */
                rows: number;
            };
            /** @description texts, each read and compared with its hash */
            contents: {
                /** @description of texts */
                count: number;
                /** @description of all */
                bytes: number;
            };
            /** @description machines with a torn block that wait for a person's confirmation */
            torn_machines: number;
            /** @description none: the store is sound */
            faults: {
                /** @description as "job/7" */
                subject: string;
                /** @description a sentence */
                what: string;
            }[];
        };
        /**
         * @description a backup in the server's folder for them
         * @example {
         *       "name": "dripfeed-2026-11-28T152506Z.backup",
         *       "bytes": 569344,
         *       "made_at_ms": 1795879506640
         *     }
         */
        Backup: {
            /** @description of the file */
            name: string;
            /** @description of the file */
            bytes: number;
            /** @description when; milliseconds since 1970, UTC */
            made_at_ms: number;
        };
        /**
         * @description a backup that was read through before it got its name
         * @example {
         *       "whole": true,
         *       "audit": {
         *         "rows": 8,
         *         "head": "ea1c0edcd4636b564357290ff6386734fa7db94d3aad5ddb871a1f8c8c137bfb"
         *       },
         *       "ledger": {
         *         "jobs": 0,
         *         "rows": 0
         *       },
         *       "contents": {
         *         "count": 3,
         *         "bytes": 1587304
         *       },
         *       "torn_machines": 0,
         *       "faults": [],
         *       "backup": "dripfeed-2026-11-28T152934Z.backup",
         *       "schema": 20,
         *       "bytes": 2142208,
         *       "holds": {
         *         "machines": 0,
         *         "families": 0,
         *         "parts": 0,
         *         "programs": 3,
         *         "releases": 0,
         *         "receipts": 0,
         *         "tokens": 5
         *       },
         *       "kept": null
         *     }
         */
        BackupMade: {
            /** @description no fault was found */
            whole: boolean;
            /** @description its chain */
            audit: {
                /** @description that were read */
                rows: number;
                /** @description hash of the last row; note it elsewhere to notice a cut end */
                head: string;
            };
            /** @description of all transfers */
            ledger: {
                /** @description with rows */
                jobs: number;
                /** @description that were read */
                rows: number;
            };
            /** @description texts, each read and compared with its hash */
            contents: {
                /** @description of texts */
                count: number;
                /** @description of all */
                bytes: number;
            };
            /** @description machines with a torn block that wait for a person's confirmation */
            torn_machines: number;
            /** @description none: the store is sound */
            faults: {
                /** @description as "job/7" */
                subject: string;
                /** @description a sentence */
                what: string;
            }[];
            /** @description name of the file */
            backup: string;
            /** @description version of the store's tables */
            schema: number;
            /** @description of the file */
            bytes: number;
            /** @description things in the backup */
            holds: {
                /** @description in it */
                machines: number;
                /** @description in it */
                families: number;
                /** @description in it */
                parts: number;
                /** @description in it */
                programs: number;
                /** @description in it */
                releases: number;
                /** @description in it */
                receipts: number;
                /** @description in it, without their secrets */
                tokens: number;
            };
            /** @description always null: nothing was replaced */
            kept: string | null;
        };
        /**
         * @description a type of event that is sent
         * @example {
         *       "name": "program.added",
         *       "when": "a program is new",
         *       "schema": "ProgramEvent"
         *     }
         */
        OutboundType: {
            /** @description of the type */
            name: string;
            /** @description it comes */
            when: string;
            /** @description of the event, in this description */
            schema: string;
        };
        /**
         * @description a job has another state
         * @example {
         *       "specversion": "1.0",
         *       "id": "1a222c393b6-6",
         *       "source": "https://dnc.shop/a",
         *       "type": "job.armed",
         *       "subject": "job/1",
         *       "time": "2026-11-28T15:26:12.406Z",
         *       "sequence": "00000000000000000006",
         *       "datacontenttype": "application/json",
         *       "data": {
         *         "job": 1,
         *         "state": "armed",
         *         "machine": "lathe",
         *         "program": 1,
         *         "revision": 1,
         *         "reason": "armed",
         *         "reason_id": "armed",
         *         "actor": "admin"
         *       }
         *     }
         */
        JobEvent: {
            /**
             * @description of CloudEvents
             * @enum {string}
             */
            specversion: "1.0";
            /** @description of the event; together with the source it is the same for each repetition, and no other */
            id: string;
            /** @description which server sends, a URI reference */
            source: string;
            /**
             * @description what happened
             * @enum {string}
             */
            type: "job.queued" | "job.armed" | "job.feeding" | "job.done" | "job.failed" | "job.cancelled" | "job.interrupted";
            /** @description what it happened to, as "job/12" */
            subject: string;
            /** @description when it happened, RFC 3339, UTC */
            time: string;
            /** @description number of the event, with leading zeros: the smaller of two came first */
            sequence: string;
            /**
             * @description of data
             * @enum {string}
             */
            datacontenttype: "application/json";
            /** @description what to know of it, and ids to ask for more */
            data: {
                /** @description its id */
                job: number;
                /**
                 * @description of the job now
                 * @enum {string}
                 */
                state: "queued" | "armed" | "feeding" | "held" | "draining" | "done" | "failed" | "cancelled" | "interrupted";
                /** @description to which it is sent */
                machine: string;
                /** @description its id */
                program: number;
                /** @description of the program's text */
                revision: number;
                /** @description of the change */
                reason: string | null;
                /** @description the same as one word or the name of a stall */
                reason_id: string | null;
                /** @description who did it: a person or program by its name, a machine, or dripfeed itself */
                actor: string;
            };
        };
        /**
         * @description a person planned a job, or confirmed its end; its state stays
         * @example {
         *       "specversion": "1.0",
         *       "id": "1a222c39de3-6",
         *       "source": "https://dnc.shop/a",
         *       "type": "job.scheduled",
         *       "subject": "job/1",
         *       "time": "2026-11-28T15:26:15.011Z",
         *       "sequence": "00000000000000000006",
         *       "datacontenttype": "application/json",
         *       "data": {
         *         "job": 1,
         *         "machine": "lathe",
         *         "program": 1,
         *         "revision": 1,
         *         "note": "at any time",
         *         "actor": "admin"
         *       }
         *     }
         */
        JobPlanEvent: {
            /**
             * @description of CloudEvents
             * @enum {string}
             */
            specversion: "1.0";
            /** @description of the event; together with the source it is the same for each repetition, and no other */
            id: string;
            /** @description which server sends, a URI reference */
            source: string;
            /**
             * @description what happened
             * @enum {string}
             */
            type: "job.scheduled" | "job.on_hold" | "job.off_hold" | "job.end_confirmed";
            /** @description what it happened to, as "job/12" */
            subject: string;
            /** @description when it happened, RFC 3339, UTC */
            time: string;
            /** @description number of the event, with leading zeros: the smaller of two came first */
            sequence: string;
            /**
             * @description of data
             * @enum {string}
             */
            datacontenttype: "application/json";
            /** @description what to know of it, and ids to ask for more */
            data: {
                /** @description its id */
                job: number;
                /** @description to which it is sent */
                machine: string;
                /** @description its id */
                program: number;
                /** @description of the program's text */
                revision: number;
                /** @description of the person, or the time that was planned; null: none */
                note: string | null;
                /** @description who did it: a person or program by its name, a machine, or dripfeed itself */
                actor: string;
            };
        };
        /**
         * @description a person stated why a transfer stood still or broke off; the job's state stays
         * @example {
         *       "specversion": "1.0",
         *       "id": "1a222c3a027-11",
         *       "source": "https://dnc.shop/a",
         *       "type": "job.stop_reason",
         *       "subject": "job/1",
         *       "time": "2026-11-28T15:26:15.591Z",
         *       "sequence": "00000000000000000011",
         *       "datacontenttype": "application/json",
         *       "data": {
         *         "job": 1,
         *         "machine": "lathe",
         *         "program": 1,
         *         "revision": 1,
         *         "note": "insert of T3",
         *         "reason": "tool broken",
         *         "actor": "the operator"
         *       }
         *     }
         */
        JobStopEvent: {
            /**
             * @description of CloudEvents
             * @enum {string}
             */
            specversion: "1.0";
            /** @description of the event; together with the source it is the same for each repetition, and no other */
            id: string;
            /** @description which server sends, a URI reference */
            source: string;
            /**
             * @description what happened
             * @enum {string}
             */
            type: "job.stop_reason";
            /** @description what it happened to, as "job/12" */
            subject: string;
            /** @description when it happened, RFC 3339, UTC */
            time: string;
            /** @description number of the event, with leading zeros: the smaller of two came first */
            sequence: string;
            /**
             * @description of data
             * @enum {string}
             */
            datacontenttype: "application/json";
            /** @description what to know of it, and ids to ask for more */
            data: {
                /** @description its id */
                job: number;
                /** @description to which it is sent */
                machine: string;
                /** @description its id */
                program: number;
                /** @description of the program's text */
                revision: number;
                /** @description one of the shop's list */
                reason: string;
                /** @description of the person; null: none */
                note: string | null;
                /** @description who did it: a person or program by its name, a machine, or dripfeed itself */
                actor: string;
            };
        };
        /**
         * @description a machine's line has had another state for a second
         * @example {
         *       "specversion": "1.0",
         *       "id": "1a222c39a3f-9",
         *       "source": "https://dnc.shop/a",
         *       "type": "line.idle",
         *       "subject": "machine/lathe",
         *       "time": "2026-11-28T15:26:14.079Z",
         *       "sequence": "00000000000000000009",
         *       "datacontenttype": "application/json",
         *       "data": {
         *         "machine": "lathe",
         *         "state": "idle",
         *         "job": 1,
         *         "stall": null,
         *         "link_error": null,
         *         "actor": "dripfeed"
         *       }
         *     }
         */
        LineEvent: {
            /**
             * @description of CloudEvents
             * @enum {string}
             */
            specversion: "1.0";
            /** @description of the event; together with the source it is the same for each repetition, and no other */
            id: string;
            /** @description which server sends, a URI reference */
            source: string;
            /**
             * @description what happened
             * @enum {string}
             */
            type: "line.disconnected" | "line.idle" | "line.armed" | "line.feeding" | "line.held" | "line.draining" | "line.torn" | "line.receiving" | "line.answering";
            /** @description what it happened to, as "job/12" */
            subject: string;
            /** @description when it happened, RFC 3339, UTC */
            time: string;
            /** @description number of the event, with leading zeros: the smaller of two came first */
            sequence: string;
            /**
             * @description of data
             * @enum {string}
             */
            datacontenttype: "application/json";
            /** @description what to know of it, and ids to ask for more */
            data: {
                /** @description its name */
                machine: string;
                /**
                 * @description of the line now
                 * @enum {string}
                 */
                state: "disconnected" | "idle" | "armed" | "feeding" | "held" | "draining" | "torn" | "receiving" | "answering";
                /** @description that has or had the line; null: none since the server's start */
                job: number | null;
                /** @description what it waits for */
                stall: string | null;
                /** @description why the link is down */
                link_error: string | null;
                /** @description who did it: a person or program by its name, a machine, or dripfeed itself */
                actor: string;
            };
        };
        /**
         * @description an alarm changed
         * @example {
         *       "specversion": "1.0",
         *       "id": "1a222c393b6-31",
         *       "source": "https://dnc.shop/a",
         *       "type": "alarm.raised",
         *       "subject": "alarm/3",
         *       "time": "2026-11-28T15:26:12.406Z",
         *       "sequence": "00000000000000000031",
         *       "datacontenttype": "application/json",
         *       "data": {
         *         "alarm": 3,
         *         "machine": "lathe-1",
         *         "kind": "link_lost",
         *         "severity": "warning",
         *         "text": "Connection reset by peer",
         *         "job": null,
         *         "actor": "dripfeed"
         *       }
         *     }
         */
        AlarmEvent: {
            /**
             * @description of CloudEvents
             * @enum {string}
             */
            specversion: "1.0";
            /** @description of the event; together with the source it is the same for each repetition, and no other */
            id: string;
            /** @description which server sends, a URI reference */
            source: string;
            /**
             * @description what happened
             * @enum {string}
             */
            type: "alarm.raised" | "alarm.cleared" | "alarm.acknowledged" | "alarm.shelved" | "alarm.unshelved";
            /** @description what it happened to, as "job/12" */
            subject: string;
            /** @description when it happened, RFC 3339, UTC */
            time: string;
            /** @description number of the event, with leading zeros: the smaller of two came first */
            sequence: string;
            /**
             * @description of data
             * @enum {string}
             */
            datacontenttype: "application/json";
            /** @description what to know of it, and ids to ask for more */
            data: {
                /** @description its id */
                alarm: number;
                /** @description its name */
                machine: string;
                /** @description what it is about, as Alarm has it */
                kind: string;
                /**
                 * @description by its kind
                 * @enum {string}
                 */
                severity: "critical" | "warning" | "notice";
                /** @description one sentence */
                text: string;
                /** @description that it is about */
                job: number | null;
                /** @description who did it: a person or program by its name, a machine, or dripfeed itself */
                actor: string;
            };
        };
        /**
         * @description a release moved on
         * @example {
         *       "specversion": "1.0",
         *       "id": "1a222c3934a-2",
         *       "source": "https://dnc.shop/a",
         *       "type": "release.draft",
         *       "subject": "release/1",
         *       "time": "2026-11-28T15:26:12.298Z",
         *       "sequence": "00000000000000000002",
         *       "datacontenttype": "application/json",
         *       "data": {
         *         "release": 1,
         *         "state": "draft",
         *         "machine": "lathe",
         *         "program": 1,
         *         "revision": 1,
         *         "note": null,
         *         "actor": "admin"
         *       }
         *     }
         */
        ReleaseEvent: {
            /**
             * @description of CloudEvents
             * @enum {string}
             */
            specversion: "1.0";
            /** @description of the event; together with the source it is the same for each repetition, and no other */
            id: string;
            /** @description which server sends, a URI reference */
            source: string;
            /**
             * @description what happened
             * @enum {string}
             */
            type: "release.draft" | "release.in_review" | "release.proving" | "release.signed_off" | "release.approved" | "release.obsolete";
            /** @description what it happened to, as "job/12" */
            subject: string;
            /** @description when it happened, RFC 3339, UTC */
            time: string;
            /** @description number of the event, with leading zeros: the smaller of two came first */
            sequence: string;
            /**
             * @description of data
             * @enum {string}
             */
            datacontenttype: "application/json";
            /** @description what to know of it, and ids to ask for more */
            data: {
                /** @description its id */
                release: number;
                /**
                 * @description of the release now
                 * @enum {string}
                 */
                state: "draft" | "in_review" | "proving" | "approved" | "obsolete";
                /** @description to which its text may go */
                machine: string;
                /** @description its id */
                program: number;
                /** @description of the program's text */
                revision: number;
                /** @description what the person wrote */
                note: string | null;
                /** @description who did it: a person or program by its name, a machine, or dripfeed itself */
                actor: string;
            };
        };
        /**
         * @description a program changed
         * @example {
         *       "specversion": "1.0",
         *       "id": "1a222c3930f-1",
         *       "source": "https://dnc.shop/a",
         *       "type": "program.added",
         *       "subject": "program/1",
         *       "time": "2026-11-28T15:26:12.239Z",
         *       "sequence": "00000000000000000001",
         *       "datacontenttype": "application/json",
         *       "data": {
         *         "program": 1,
         *         "name": "O0042",
         *         "revision": 1,
         *         "machine": null,
         *         "actor": "admin"
         *       }
         *     }
         */
        ProgramEvent: {
            /**
             * @description of CloudEvents
             * @enum {string}
             */
            specversion: "1.0";
            /** @description of the event; together with the source it is the same for each repetition, and no other */
            id: string;
            /** @description which server sends, a URI reference */
            source: string;
            /**
             * @description what happened
             * @enum {string}
             */
            type: "program.added" | "program.revised" | "program.archived" | "program.fetched_back" | "program.deleted";
            /** @description what it happened to, as "job/12" */
            subject: string;
            /** @description when it happened, RFC 3339, UTC */
            time: string;
            /** @description number of the event, with leading zeros: the smaller of two came first */
            sequence: string;
            /**
             * @description of data
             * @enum {string}
             */
            datacontenttype: "application/json";
            /** @description what to know of it, and ids to ask for more */
            data: {
                /** @description its id */
                program: number;
                /** @description under which the control calls it */
                name: string;
                /** @description the newest of its text */
                revision: number;
                /** @description for which it was rendered */
                machine: string | null;
                /** @description who did it: a person or program by its name, a machine, or dripfeed itself */
                actor: string;
            };
        };
        /**
         * @description an order is new or changed
         * @example {
         *       "specversion": "1.0",
         *       "id": "1a222c393b6-32",
         *       "source": "https://dnc.shop/a",
         *       "type": "order.parts",
         *       "subject": "order/31",
         *       "time": "2026-11-28T15:26:12.406Z",
         *       "sequence": "00000000000000000032",
         *       "datacontenttype": "application/json",
         *       "data": {
         *         "order": 31,
         *         "number": "4711",
         *         "machine": null,
         *         "actor": "the MES"
         *       }
         *     }
         */
        OrderEvent: {
            /**
             * @description of CloudEvents
             * @enum {string}
             */
            specversion: "1.0";
            /** @description of the event; together with the source it is the same for each repetition, and no other */
            id: string;
            /** @description which server sends, a URI reference */
            source: string;
            /**
             * @description what happened
             * @enum {string}
             */
            type: "order.added" | "order.changed" | "order.parts" | "order.open" | "order.held" | "order.done" | "order.cancelled";
            /** @description what it happened to, as "job/12" */
            subject: string;
            /** @description when it happened, RFC 3339, UTC */
            time: string;
            /** @description number of the event, with leading zeros: the smaller of two came first */
            sequence: string;
            /**
             * @description of data
             * @enum {string}
             */
            datacontenttype: "application/json";
            /** @description what to know of it, and ids to ask for more */
            data: {
                /** @description its id */
                order: number;
                /** @description of the order, as its planner says */
                number: string;
                /** @description for which it is; null: not decided */
                machine: string | null;
                /** @description who did it: a person or program by its name, a machine, or dripfeed itself */
                actor: string;
            };
        };
        /**
         * @description something that a control punched
         * @example {
         *       "specversion": "1.0",
         *       "id": "1a222c393b6-33",
         *       "source": "https://dnc.shop/a",
         *       "type": "receipt.stored",
         *       "subject": "receipt/4",
         *       "time": "2026-11-28T15:26:12.406Z",
         *       "sequence": "00000000000000000033",
         *       "datacontenttype": "application/json",
         *       "data": {
         *         "receipt": 4,
         *         "state": "stored",
         *         "machine": "lathe-1",
         *         "name": "O0700",
         *         "program": null,
         *         "revision": null,
         *         "actor": "dripfeed"
         *       }
         *     }
         */
        ReceiptEvent: {
            /**
             * @description of CloudEvents
             * @enum {string}
             */
            specversion: "1.0";
            /** @description of the event; together with the source it is the same for each repetition, and no other */
            id: string;
            /** @description which server sends, a URI reference */
            source: string;
            /**
             * @description what happened
             * @enum {string}
             */
            type: "receipt.stored" | "receipt.quarantined" | "receipt.accepted" | "receipt.discarded";
            /** @description what it happened to, as "job/12" */
            subject: string;
            /** @description when it happened, RFC 3339, UTC */
            time: string;
            /** @description number of the event, with leading zeros: the smaller of two came first */
            sequence: string;
            /**
             * @description of data
             * @enum {string}
             */
            datacontenttype: "application/json";
            /** @description what to know of it, and ids to ask for more */
            data: {
                /** @description its id */
                receipt: number;
                /**
                 * @description of the receipt now
                 * @enum {string}
                 */
                state: "stored" | "quarantined" | "accepted" | "discarded";
                /** @description whose control punched it */
                machine: string;
                /** @description as the program names itself, or by its time */
                name: string;
                /** @description that it became */
                program: number | null;
                /** @description of that program */
                revision: number | null;
                /** @description who did it: a person or program by its name, a machine, or dripfeed itself */
                actor: string;
            };
        };
        /**
         * @description a person tries a webhook
         * @example {
         *       "specversion": "1.0",
         *       "id": "1a222c39a7a-10",
         *       "source": "https://dnc.shop/a",
         *       "type": "webhook.ping",
         *       "subject": "webhook/1",
         *       "time": "2026-11-28T15:26:14.138Z",
         *       "sequence": "00000000000000000010",
         *       "datacontenttype": "application/json",
         *       "data": {
         *         "webhook": 1,
         *         "actor": "admin"
         *       }
         *     }
         */
        WebhookEvent: {
            /**
             * @description of CloudEvents
             * @enum {string}
             */
            specversion: "1.0";
            /** @description of the event; together with the source it is the same for each repetition, and no other */
            id: string;
            /** @description which server sends, a URI reference */
            source: string;
            /**
             * @description what happened
             * @enum {string}
             */
            type: "webhook.ping";
            /** @description what it happened to, as "job/12" */
            subject: string;
            /** @description when it happened, RFC 3339, UTC */
            time: string;
            /** @description number of the event, with leading zeros: the smaller of two came first */
            sequence: string;
            /**
             * @description of data
             * @enum {string}
             */
            datacontenttype: "application/json";
            /** @description what to know of it, and ids to ask for more */
            data: {
                /** @description its id */
                webhook: number;
                /** @description who did it: a person or program by its name, a machine, or dripfeed itself */
                actor: string;
            };
        };
        /**
         * @description who receives events by HTTP
         * @example {
         *       "id": 1,
         *       "url": "https://mes.shop/dripfeed",
         *       "types": [
         *         "*"
         *       ],
         *       "description": "the MES",
         *       "enabled": true,
         *       "local": false,
         *       "why_disabled": null,
         *       "old_secret_until_ms": null,
         *       "missed": 0,
         *       "created_by": "admin",
         *       "created_at_ms": 1795879517435,
         *       "changed_at_ms": 1795879517533
         *     }
         */
        Webhook: {
            /** @description of the webhook */
            id: number;
            /** @description where events are posted */
            url: string;
            /** @description that it gets */
            types: string[];
            /** @description for people */
            description: string;
            /** @description events are sent */
            enabled: boolean;
            /** @description it may lie in a private network or on the server's computer, and may be plain http */
            local: boolean;
            /** @description null: it is enabled, or a person disabled it */
            why_disabled: string | null;
            /** @description until then the previous secret also signs; milliseconds since 1970, UTC */
            old_secret_until_ms: number | null;
            /** @description events that were forgotten before they could be sent */
            missed: number;
            /** @description who made it */
            created_by: string;
            /** @description when it was made; milliseconds since 1970, UTC */
            created_at_ms: number;
            /** @description when a person changed it last; milliseconds since 1970, UTC */
            changed_at_ms: number;
        };
        /**
         * @description a webhook with its new secret, which is shown once
         * @example {
         *       "id": 1,
         *       "url": "https://mes.shop/dripfeed",
         *       "types": [
         *         "*"
         *       ],
         *       "description": "the MES",
         *       "enabled": true,
         *       "local": false,
         *       "why_disabled": null,
         *       "old_secret_until_ms": 1795965917573,
         *       "missed": 0,
         *       "created_by": "admin",
         *       "created_at_ms": 1795879517435,
         *       "changed_at_ms": 1795879517573,
         *       "secret": "whsec_ZHJpcGZlZWQgZXhhbXBsZSBzZWNyZXQ="
         *     }
         */
        WebhookSecret: {
            /** @description of the webhook */
            id: number;
            /** @description where events are posted */
            url: string;
            /** @description that it gets */
            types: string[];
            /** @description for people */
            description: string;
            /** @description events are sent */
            enabled: boolean;
            /** @description it may lie in a private network or on the server's computer, and may be plain http */
            local: boolean;
            /** @description null: it is enabled, or a person disabled it */
            why_disabled: string | null;
            /** @description until then the previous secret also signs; milliseconds since 1970, UTC */
            old_secret_until_ms: number | null;
            /** @description events that were forgotten before they could be sent */
            missed: number;
            /** @description who made it */
            created_by: string;
            /** @description when it was made; milliseconds since 1970, UTC */
            created_at_ms: number;
            /** @description when a person changed it last; milliseconds since 1970, UTC */
            changed_at_ms: number;
            /** @description for the signatures: whsec_ and base64 */
            secret: string;
        };
        /**
         * @description the delivery of one event to one webhook
         * @example {
         *       "id": 1,
         *       "webhook": 1,
         *       "event": "1a222c2bdaa-28",
         *       "type": "webhook.ping",
         *       "happened_at_ms": 1795879517610,
         *       "state": "pending",
         *       "attempts": 0,
         *       "next_at_ms": 1795879517676,
         *       "last_at_ms": 1795879517630,
         *       "last_status": null,
         *       "last_error": "Failed to connect to mes.shop port 443 after 12 ms: Couldn't connect to server"
         *     }
         */
        WebhookDelivery: {
            /** @description of the delivery */
            id: number;
            /** @description its id */
            webhook: number;
            /** @description its id, which is also the header webhook-id */
            event: string;
            /** @description of the event */
            type: string;
            /** @description when the event happened; milliseconds since 1970, UTC */
            happened_at_ms: number;
            /**
             * @description pending: to be tried; dead: all tries failed, it may be replayed
             * @enum {string}
             */
            state: "pending" | "delivered" | "dead";
            /** @description tries since it was made or replayed */
            attempts: number;
            /** @description of the next try; milliseconds since 1970, UTC */
            next_at_ms: number | null;
            /** @description of the last try; milliseconds since 1970, UTC */
            last_at_ms: number | null;
            /** @description of HTTP; null: no answer came */
            last_status: number | null;
            /** @description why no answer came */
            last_error: string | null;
        };
        /**
         * @description what is tried again
         * @example {
         *       "replayed": 2
         *     }
         */
        Replayed: {
            /** @description deliveries */
            replayed: number;
        };
        /**
         * @description what is to be made, as a MES or a planner says
         * @example {
         *       "id": 31,
         *       "number": "4711",
         *       "operation": "20",
         *       "part": "HUB-12",
         *       "quantity": 50,
         *       "machine": "lathe-1",
         *       "due_at_ms": 1795600800000,
         *       "priority": 10,
         *       "metadata": {
         *         "cost_center": "A7"
         *       },
         *       "state": "open",
         *       "reason": null,
         *       "good": 12,
         *       "scrap": 1,
         *       "open": 38,
         *       "transfers": 1,
         *       "waiting": 0,
         *       "revision": 3,
         *       "created_by": "the MES",
         *       "created_at_ms": 1795500000000,
         *       "changed_at_ms": 1795503600000
         *     }
         */
        Order: {
            /** @description of the order */
            id: number;
            /** @description of the planner; with the operation there is one order of it */
            number: string;
            /** @description of the routing; null: there is none */
            operation: string | null;
            /** @description its number */
            part: string;
            /** @description good parts that are wanted */
            quantity: number;
            /** @description for which it is; null: not decided */
            machine: string | null;
            /** @description until then; milliseconds since 1970, UTC */
            due_at_ms: number | null;
            /** @description the higher the sooner */
            priority: number;
            /** @description as it came */
            metadata: {
                [key: string]: unknown;
            };
            /**
             * @description jobs are queued and armed while it is open
             * @enum {string}
             */
            state: "open" | "held" | "done" | "cancelled";
            /** @description of the last change of its state */
            reason: string | null;
            /** @description parts that were reported good */
            good: number;
            /** @description parts that were reported as scrap */
            scrap: number;
            /** @description good parts that are missing */
            open: number;
            /** @description jobs of it that are done; no count of parts */
            transfers: number;
            /** @description jobs of it that are queued */
            waiting: number;
            /** @description of the plan */
            revision: number;
            /** @description who made it */
            created_by: string;
            /** @description when; milliseconds since 1970, UTC */
            created_at_ms: number;
            /** @description of plan or state; milliseconds since 1970, UTC */
            changed_at_ms: number;
        };
        /**
         * @description a page of a list
         * @example {
         *       "items": [
         *         {
         *           "name": "lathe-0",
         *           "revision": 1,
         *           "title": "Lathe with Fanuc 0i-TF",
         *           "dialect": "fanuc",
         *           "kind": "lathe",
         *           "link": "tcp://10.0.0.21:4001",
         *           "status": {
         *             "line": "feeding",
         *             "stall": null,
         *             "stop_wanted": false,
         *             "link_error": null,
         *             "link_error_id": null,
         *             "link_error_said": null,
         *             "link_note": null,
         *             "link_note_id": null,
         *             "line_errors": {
         *               "parity": 0,
         *               "framing": 0,
         *               "overrun": 0,
         *               "breaks": 0
         *             },
         *             "asks_since_ms": null,
         *             "asks": 0,
         *             "job": 1,
         *             "handed": 68016,
         *             "clocked": 66985,
         *             "confirmed": 0,
         *             "confirms": false,
         *             "estimated": true,
         *             "total": 78881,
         *             "block_from": 2568,
         *             "block": 2606,
         *             "holds": 0,
         *             "hold_s": 0,
         *             "line_use": 0.989,
         *             "plc": null,
         *             "program": "O0042",
         *             "block_text": "G01 X50.100 Z-129.900 F0.2",
         *             "needs_confirmation": null
         *           }
         *         }
         *       ],
         *       "next": null
         *     }
         */
        MachineSummaryPage: {
            /** @description in the list's order */
            items: components["schemas"]["MachineSummary"][];
            /** @description for `after` of the next page; null: the last */
            next: string | null;
        };
        /**
         * @description a page of a list
         * @example {
         *       "items": [
         *         {
         *           "name": "hall-1",
         *           "this": true,
         *           "url": "https://dnc-1.shop",
         *           "version": "0.1.0",
         *           "answers": true,
         *           "started_at_ms": 1795500000000,
         *           "seen_at_ms": 1795507200000,
         *           "machines": [
         *             {
         *               "name": "lathe-1",
         *               "lease": 3,
         *               "since_ms": 1795500000000,
         *               "given_by": "dripfeed",
         *               "reason": null
         *             }
         *           ]
         *         }
         *       ],
         *       "next": null
         *     }
         */
        NodePage: {
            /** @description in the list's order */
            items: components["schemas"]["Node"][];
            /** @description for `after` of the next page; null: the last */
            next: string | null;
        };
        /**
         * @description a page of a list
         * @example {
         *       "items": [
         *         {
         *           "name": "lathes",
         *           "machines": [
         *             "lathe",
         *             "second",
         *             "third"
         *           ],
         *           "four_eyes": false,
         *           "operator_sign_off": true
         *         }
         *       ],
         *       "next": null
         *     }
         */
        MachineGroupPage: {
            /** @description in the list's order */
            items: components["schemas"]["MachineGroup"][];
            /** @description for `after` of the next page; null: the last */
            next: string | null;
        };
        /**
         * @description a page of a list
         * @example {
         *       "items": [
         *         {
         *           "name": "olga",
         *           "provider": null,
         *           "role": "programmer",
         *           "grants": [],
         *           "has_password": true,
         *           "has_pin": true,
         *           "failures": 0,
         *           "locked_until_ms": null,
         *           "disabled_at_ms": 1795879437507,
         *           "revision": 2,
         *           "created_by": "admin",
         *           "created_at_ms": 1795879435708
         *         }
         *       ],
         *       "next": null
         *     }
         */
        UserPage: {
            /** @description in the list's order */
            items: components["schemas"]["User"][];
            /** @description for `after` of the next page; null: the last */
            next: string | null;
        };
        /**
         * @description a page of a list
         * @example {
         *       "items": [
         *         {
         *           "id": 13,
         *           "name": "wall",
         *           "role": "viewer",
         *           "user": null,
         *           "scope": [],
         *           "created_by": "admin",
         *           "created_at_ms": 1795879506246,
         *           "expires_at_ms": null,
         *           "revoked_at_ms": null
         *         }
         *       ],
         *       "next": null
         *     }
         */
        TokenPage: {
            /** @description in the list's order */
            items: components["schemas"]["Token"][];
            /** @description for `after` of the next page; null: the last */
            next: string | null;
        };
        /**
         * @description a page of a list
         * @example {
         *       "items": [
         *         {
         *           "seq": 39,
         *           "at_ms": 1795879506283,
         *           "actor": "admin",
         *           "action": "token.revoke",
         *           "subject": "token/13",
         *           "detail": "wall",
         *           "previous_hash": "663263f0b25684ca3895d85d0c3a48ebb7970acee75e3c53340682ce01aba4fd",
         *           "hash": "017733a229f635d939071ebbc0929dacea3333a42b1bac3d5fd59915099d1655"
         *         }
         *       ],
         *       "next": null
         *     }
         */
        AuditRowPage: {
            /** @description in the list's order */
            items: components["schemas"]["AuditRow"][];
            /** @description for `after` of the next page; null: the last */
            next: string | null;
        };
        /**
         * @description a page of a list
         * @example {
         *       "items": [
         *         {
         *           "name": "dripfeed-2026-11-28T152506Z.backup",
         *           "bytes": 569344,
         *           "made_at_ms": 1795879506640
         *         }
         *       ],
         *       "next": null
         *     }
         */
        BackupPage: {
            /** @description in the list's order */
            items: components["schemas"]["Backup"][];
            /** @description for `after` of the next page; null: the last */
            next: string | null;
        };
        /**
         * @description a page of a list
         * @example {
         *       "items": [
         *         {
         *           "name": "hyperbolic-roll",
         *           "title": "Hyperbolic rolling-mill roll",
         *           "revision": 1,
         *           "changed_by": "the programmer",
         *           "changed_at_ms": 1795879506857
         *         }
         *       ],
         *       "next": null
         *     }
         */
        FamilySummaryPage: {
            /** @description in the list's order */
            items: components["schemas"]["FamilySummary"][];
            /** @description for `after` of the next page; null: the last */
            next: string | null;
        };
        /**
         * @description a page of a list
         * @example {
         *       "items": [
         *         {
         *           "number": "R-1",
         *           "revision": 2,
         *           "family": "hyperbolic-roll",
         *           "family_revision": 2,
         *           "values": {
         *             "angle_step": "1 deg"
         *           },
         *           "changed_by": "the programmer",
         *           "changed_at_ms": 1795879506950
         *         }
         *       ],
         *       "next": null
         *     }
         */
        PartPage: {
            /** @description in the list's order */
            items: components["schemas"]["Part"][];
            /** @description for `after` of the next page; null: the last */
            next: string | null;
        };
        /**
         * @description a page of a list
         * @example {
         *       "items": [
         *         {
         *           "id": 77,
         *           "name": "O0042",
         *           "dialect": "fanuc",
         *           "tags": [
         *             "hub"
         *           ],
         *           "folder": null,
         *           "archived": null,
         *           "deleted": null,
         *           "revision": 1,
         *           "sha256": "9f2c4e0b8a6d1f3579bd02468ace13579bdf02468ace13579bdf02468ace1357",
         *           "bytes": 24,
         *           "blocks": 3,
         *           "origin": {
         *             "kind": "uploaded"
         *           },
         *           "created_by": "the MES",
         *           "created_at_ms": 1795500100000
         *         }
         *       ],
         *       "next": null
         *     }
         */
        ProgramPage: {
            /** @description in the list's order */
            items: components["schemas"]["Program"][];
            /** @description for `after` of the next page; null: the last */
            next: string | null;
        };
        /**
         * @description a page of a list
         * @example {
         *       "items": [
         *         {
         *           "id": 2,
         *           "revision": 2,
         *           "sha256": "f9d057e3f0ca2812ff3706a9859af1125ae513181d084c35a4c46400cb3c4933",
         *           "bytes": 51908,
         *           "blocks": 2010,
         *           "origin": {
         *             "kind": "uploaded"
         *           },
         *           "created_by": "the programmer",
         *           "created_at_ms": 1795879507303
         *         }
         *       ],
         *       "next": null
         *     }
         */
        ProgramRevisionPage: {
            /** @description in the list's order */
            items: components["schemas"]["ProgramRevision"][];
            /** @description for `after` of the next page; null: the last */
            next: string | null;
        };
        /**
         * @description a page of a list
         * @example {
         *       "items": [
         *         {
         *           "id": 1,
         *           "program": 2,
         *           "family": null,
         *           "part": null,
         *           "order": null,
         *           "name": "sheet.pdf",
         *           "media_type": "application/octet-stream",
         *           "bytes": 8,
         *           "sha256": "e16fa5d9b51928755db85b917f0297babaf22c7a47e97d9212adab56e61ba04e",
         *           "added_by": "the programmer",
         *           "added_at_ms": 1795879507371,
         *           "removed": {
         *             "by": "the programmer",
         *             "reason": "of another part",
         *             "at_ms": 1795879507474
         *           }
         *         }
         *       ],
         *       "next": null
         *     }
         */
        AttachmentPage: {
            /** @description in the list's order */
            items: components["schemas"]["Attachment"][];
            /** @description for `after` of the next page; null: the last */
            next: string | null;
        };
        /**
         * @description a page of a list
         * @example {
         *       "items": [
         *         {
         *           "id": 140,
         *           "program": 77,
         *           "revision": 1,
         *           "sha256": "9f2c4e0b8a6d1f3579bd02468ace13579bdf02468ace13579bdf02468ace1357",
         *           "machine": "lathe-1",
         *           "machine_revision": 4,
         *           "delivery": "drip",
         *           "verdict": "pass",
         *           "rules": "2f0d3a91c4be7765",
         *           "stale": false,
         *           "created_by": "the MES",
         *           "created_at_ms": 1795500200000,
         *           "calls": [],
         *           "points": [],
         *           "waivers": []
         *         }
         *       ],
         *       "next": null
         *     }
         */
        VerdictSummaryPage: {
            /** @description in the list's order */
            items: components["schemas"]["VerdictSummary"][];
            /** @description for `after` of the next page; null: the last */
            next: string | null;
        };
        /**
         * @description a page of a list
         * @example {
         *       "items": [
         *         {
         *           "id": 55,
         *           "kind": "check",
         *           "subject": "program/7",
         *           "machine": "lathe",
         *           "actor": "the programmer",
         *           "state": "running",
         *           "place": null,
         *           "waiting_since_ms": 1795879519557,
         *           "running_since_ms": 1795879519557,
         *           "budget_s": 60
         *         }
         *       ],
         *       "next": null
         *     }
         */
        WorkPage: {
            /** @description in the list's order */
            items: components["schemas"]["Work"][];
            /** @description for `after` of the next page; null: the last */
            next: string | null;
        };
        /**
         * @description a page of a list
         * @example {
         *       "items": [
         *         {
         *           "id": 17,
         *           "state": "approved",
         *           "program": 77,
         *           "revision": 1,
         *           "machine": "lathe-1",
         *           "delivery": "drip",
         *           "sha256": "9f2c4e0b8a6d1f3579bd02468ace13579bdf02468ace13579bdf02468ace1357",
         *           "restart": null,
         *           "transfers_allowed": 3,
         *           "transfers_done": 1,
         *           "proved_by": "olga",
         *           "proof": "first part measured, all sizes in the middle",
         *           "created_by": "paula",
         *           "created_at_ms": 1795500300000,
         *           "approved_by": "anna",
         *           "sign_off": "first part measured",
         *           "changed_at_ms": 1795507200000
         *         }
         *       ],
         *       "next": null
         *     }
         */
        ReleasePage: {
            /** @description in the list's order */
            items: components["schemas"]["Release"][];
            /** @description for `after` of the next page; null: the last */
            next: string | null;
        };
        /**
         * @description a page of a list
         * @example {
         *       "items": [
         *         {
         *           "id": 31,
         *           "number": "4711",
         *           "operation": "20",
         *           "part": "HUB-12",
         *           "quantity": 50,
         *           "machine": "lathe-1",
         *           "due_at_ms": 1795600800000,
         *           "priority": 10,
         *           "metadata": {
         *             "cost_center": "A7"
         *           },
         *           "state": "open",
         *           "reason": null,
         *           "good": 12,
         *           "scrap": 1,
         *           "open": 38,
         *           "transfers": 1,
         *           "waiting": 0,
         *           "revision": 3,
         *           "created_by": "the MES",
         *           "created_at_ms": 1795500000000,
         *           "changed_at_ms": 1795503600000
         *         }
         *       ],
         *       "next": null
         *     }
         */
        OrderPage: {
            /** @description in the list's order */
            items: components["schemas"]["Order"][];
            /** @description for `after` of the next page; null: the last */
            next: string | null;
        };
        /**
         * @description a page of a list
         * @example {
         *       "items": [
         *         {
         *           "id": 412,
         *           "state": "feeding",
         *           "machine": "lathe-1",
         *           "release": 17,
         *           "order": 31,
         *           "restart": null,
         *           "program": 77,
         *           "revision": 1,
         *           "sha256": "9f2c4e0b8a6d1f3579bd02468ace13579bdf02468ace13579bdf02468ace1357",
         *           "delivery": "drip",
         *           "link": "tcp://10.0.0.21:4001",
         *           "bytes": 24,
         *           "reason": "",
         *           "reason_id": null,
         *           "reason_said": null,
         *           "rank": 1,
         *           "created_by": "the MES",
         *           "created_at_ms": 1795500400000,
         *           "armed_by": "olga",
         *           "armed_at_ms": 1795500500000,
         *           "expires_at_ms": 1795501100000,
         *           "started_at_ms": 1795500512000,
         *           "ended_at_ms": null,
         *           "held_s": null,
         *           "holds": null,
         *           "line_s": null,
         *           "forecast_s": 38.4,
         *           "torn": false,
         *           "not_before_ms": null,
         *           "on_hold": null,
         *           "retry_of": null,
         *           "choice": null,
         *           "end_check": "part taken out",
         *           "needs_end_confirmation": false,
         *           "end_confirmed_by": null,
         *           "end_confirmed_at_ms": null,
         *           "end_note": null,
         *           "needs_confirmation": false,
         *           "confirmed_by": null,
         *           "confirm_reason": null,
         *           "read_back": null,
         *           "read_back_state": null
         *         }
         *       ],
         *       "next": null
         *     }
         */
        JobPage: {
            /** @description in the list's order */
            items: components["schemas"]["Job"][];
            /** @description for `after` of the next page; null: the last */
            next: string | null;
        };
        /**
         * @description a page of a list
         * @example {
         *       "items": [
         *         {
         *           "id": 1,
         *           "machine": "lathe",
         *           "kind": "torn_block",
         *           "text": "link_lost: between wire byte 0 and 29 of 3831 may have reached the control (line 1 to 5); a block is torn: reset the control and confirm it; Connection reset by peer",
         *           "said": {
         *             "id": "reached_torn_because_lines",
         *             "values": {
         *               "cause": {
         *                 "text": "link_lost",
         *                 "said": null
         *               },
         *               "from": {
         *                 "text": "0",
         *                 "said": null
         *               },
         *               "to": {
         *                 "text": "29",
         *                 "said": null
         *               },
         *               "total": {
         *                 "text": "3831",
         *                 "said": null
         *               },
         *               "first": {
         *                 "text": "1",
         *                 "said": null
         *               },
         *               "last": {
         *                 "text": "5",
         *                 "said": null
         *               },
         *               "why": {
         *                 "text": "Connection reset by peer",
         *                 "said": null
         *               }
         *             }
         *           },
         *           "count": 1,
         *           "severity": "critical",
         *           "raised_at_ms": 1795879628552,
         *           "last_at_ms": 1795879628552,
         *           "cleared_at_ms": null,
         *           "acknowledged_by": "the operator",
         *           "acknowledged_at_ms": 1795879629845,
         *           "shelved_by": null,
         *           "shelved_until_ms": null,
         *           "shelf_reason": null,
         *           "job": 1
         *         }
         *       ],
         *       "next": null
         *     }
         */
        AlarmPage: {
            /** @description in the list's order */
            items: components["schemas"]["Alarm"][];
            /** @description for `after` of the next page; null: the last */
            next: string | null;
        };
        /**
         * @description a page of a list
         * @example {
         *       "items": [
         *         {
         *           "name": "program.added",
         *           "when": "a program is new",
         *           "schema": "ProgramEvent"
         *         }
         *       ],
         *       "next": null
         *     }
         */
        OutboundTypePage: {
            /** @description in the list's order */
            items: components["schemas"]["OutboundType"][];
            /** @description for `after` of the next page; null: the last */
            next: string | null;
        };
        /**
         * @description a page of a list
         * @example {
         *       "items": [
         *         {
         *           "id": 1,
         *           "url": "https://mes.shop/dripfeed",
         *           "types": [
         *             "*"
         *           ],
         *           "description": "the MES",
         *           "enabled": true,
         *           "local": false,
         *           "why_disabled": null,
         *           "old_secret_until_ms": null,
         *           "missed": 0,
         *           "created_by": "admin",
         *           "created_at_ms": 1795879517435,
         *           "changed_at_ms": 1795879517533
         *         }
         *       ],
         *       "next": null
         *     }
         */
        WebhookPage: {
            /** @description in the list's order */
            items: components["schemas"]["Webhook"][];
            /** @description for `after` of the next page; null: the last */
            next: string | null;
        };
        /**
         * @description a page of a list
         * @example {
         *       "items": [
         *         {
         *           "id": 1,
         *           "webhook": 1,
         *           "event": "1a222c2bdaa-28",
         *           "type": "webhook.ping",
         *           "happened_at_ms": 1795879517610,
         *           "state": "pending",
         *           "attempts": 0,
         *           "next_at_ms": 1795879517676,
         *           "last_at_ms": 1795879517630,
         *           "last_status": null,
         *           "last_error": "Failed to connect to mes.shop port 443 after 12 ms: Couldn't connect to server"
         *         }
         *       ],
         *       "next": null
         *     }
         */
        WebhookDeliveryPage: {
            /** @description in the list's order */
            items: components["schemas"]["WebhookDelivery"][];
            /** @description for `after` of the next page; null: the last */
            next: string | null;
        };
        /**
         * @description a page of a list
         * @example {
         *       "items": [
         *         {
         *           "id": 4,
         *           "machine": "lathe",
         *           "at_ms": 1795879620539,
         *           "name": "O9",
         *           "named_by": "number",
         *           "state": "accepted",
         *           "reason": "characters have wrong parity (2, the first at byte 5)",
         *           "sha256": "8e539c21a2115c6f0c04b2446603d875fd2de00719fd8d3cdbe9c1fbc790697e",
         *           "bytes": 11,
         *           "raw_bytes": 11,
         *           "code": "iso",
         *           "ended_by": "punch_off",
         *           "stored": null,
         *           "program": 2,
         *           "revision": 1,
         *           "decided_by": "the approver",
         *           "decided_reason": "only its end is missing",
         *           "decided_at_ms": 1795879620569
         *         }
         *       ],
         *       "next": null
         *     }
         */
        ReceiptPage: {
            /** @description in the list's order */
            items: components["schemas"]["Receipt"][];
            /** @description for `after` of the next page; null: the last */
            next: string | null;
        };
        /**
         * @description a page of a list
         * @example {
         *       "items": [
         *         {
         *           "id": 8,
         *           "machine": "lathe",
         *           "at_ms": 1795879625020,
         *           "verb": "load",
         *           "argument": "42",
         *           "text": "%\nO9999(LOAD 42)\n%\n",
         *           "outcome": "armed",
         *           "detail": "O0042 as job 3",
         *           "job": 3
         *         }
         *       ],
         *       "next": null
         *     }
         */
        OperatorRequestPage: {
            /** @description in the list's order */
            items: components["schemas"]["OperatorRequest"][];
            /** @description for `after` of the next page; null: the last */
            next: string | null;
        };
    };
    responses: {
        /** @description `malformed`: the request cannot be read, or has a query parameter that is not known */
        Problem400: {
            headers: {
                [name: string]: unknown;
            };
            content: {
                "application/problem+json": components["schemas"]["Problem"];
            };
        };
        /** @description `not_signed_in`: there is no token and no session, or it has ended; `wrong_secret`: the name, password, PIN or token is wrong */
        Problem401: {
            headers: {
                /** @description how to authenticate */
                "WWW-Authenticate": string;
                [name: string]: unknown;
            };
            content: {
                "application/problem+json": components["schemas"]["Problem"];
            };
        };
        /** @description `not_allowed`: the caller may not do this; `role_missing`: the caller's role is too low for this, or for this machine; `scope_missing`: the token's scope does not contain this change */
        Problem403: {
            headers: {
                [name: string]: unknown;
            };
            content: {
                "application/problem+json": components["schemas"]["Problem"];
            };
        };
        /** @description `not_found`: there is no such route or thing */
        Problem404: {
            headers: {
                [name: string]: unknown;
            };
            content: {
                "application/problem+json": components["schemas"]["Problem"];
            };
        };
        /** @description `refused`: the state of things does not allow it now; `exists`: the name or number is taken; `in_progress`: the same is being done: ask again when it has ended; `other_user`: the page shows another person than the one who is signed in; `wrong_state`: this cannot follow the present state; `no_verdict`: the text was never checked for this machine and delivery; `verdict_not_passed`: the newest verdict does not clear the text; `verdict_stale`: what it rests on changed after the verdict: check again; `not_released`: no release lets this text go to this machine; `no_machine_of_group`: no machine of the group can take the program: see `errors`; `transfers_used_up`: the proving has had its transfers; `sign_off_missing`: an approval needs a note of who signs it off; `not_proved`: an operator signs off what a transfer has shown: none has ended well since the proving began; `not_signed_off`: a release is approved for this machine after an operator signed its proving off; `four_eyes`: who wrote or released a text may not approve it; `machine_busy`: a job has the machine's line; `machine_torn`: a block may be torn: a person resets the control and confirms that; `too_early`: the job may not be armed before its time; `on_hold`: a person put the job on hold: the detail names who, and why; `end_not_confirmed`: a person must first confirm the end of another job of the machine: the detail names it and what is asked; `hook_refused`: the system that is asked before an arming refuses it: its words are in the detail; `hook_unanswered`: the system that is asked before an arming gives no answer; `sign_in_not_begun`: this browser did not begin this sign-in by the provider, or it took too long, or was used; `provider_refused`: the OpenID Connect provider refuses the sign-in; `id_token_refused`: what the provider signed is not taken: the detail names the rule; `name_taken`: the provider's name for the person belongs to another account here, or is not a name; `account_waits`: an administrator has to enable the account, or it is locked; `no_role`: no group of the person at the provider gives a role here; `line_down`: the machine has no line, or its link is down; `append_only`: what is written there never changes */
        Problem409: {
            headers: {
                [name: string]: unknown;
            };
            content: {
                "application/problem+json": components["schemas"]["Problem"];
            };
        };
        /** @description `stale_revision`: another change came first: read it again */
        Problem412: {
            headers: {
                [name: string]: unknown;
            };
            content: {
                "application/problem+json": components["schemas"]["Problem"];
            };
        };
        /** @description `too_large`: the body is too long for this route, or for the limits of this shop */
        Problem413: {
            headers: {
                [name: string]: unknown;
            };
            content: {
                "application/problem+json": components["schemas"]["Problem"];
            };
        };
        /** @description `no_json`: the body is not JSON, or is encoded */
        Problem415: {
            headers: {
                [name: string]: unknown;
            };
            content: {
                "application/problem+json": components["schemas"]["Problem"];
            };
        };
        /** @description `invalid`: a value is missing or wrong: see `errors`; `key_reused`: the idempotency key was used for another request */
        Problem422: {
            headers: {
                [name: string]: unknown;
            };
            content: {
                "application/problem+json": components["schemas"]["Problem"];
            };
        };
        /** @description `revision_missing`: If-Match with the revision that is changed is needed */
        Problem428: {
            headers: {
                [name: string]: unknown;
            };
            content: {
                "application/problem+json": components["schemas"]["Problem"];
            };
        };
        /** @description `too_many`: too many wrong secrets, or too many who watch */
        Problem429: {
            headers: {
                /** @description seconds after which asking again may help */
                "Retry-After": number;
                [name: string]: unknown;
            };
            content: {
                "application/problem+json": components["schemas"]["Problem"];
            };
        };
        /** @description `internal`: the request failed inside the server; the log states why */
        Problem500: {
            headers: {
                [name: string]: unknown;
            };
            content: {
                "application/problem+json": components["schemas"]["Problem"];
            };
        };
        /** @description `unavailable`: the server cannot do it for now; `provider_unanswered`: the OpenID Connect provider gives no answer, or none that can be used; passwords and PINs still work; `overloaded`: too many requests wait: send it again; `disk_full`: the disk is full: running work is finished, nothing new begins */
        Problem503: {
            headers: {
                /** @description seconds after which asking again may help */
                "Retry-After": number;
                [name: string]: unknown;
            };
            content: {
                "application/problem+json": components["schemas"]["Problem"];
            };
        };
        /** @description `no_room`: the body could not be kept on the disk; `over_quota`: the store has reached the limit of its options: a person must make room */
        Problem507: {
            headers: {
                [name: string]: unknown;
            };
            content: {
                "application/problem+json": components["schemas"]["Problem"];
            };
        };
    };
    parameters: never;
    requestBodies: never;
    headers: never;
    pathItems: never;
}
export type $defs = Record<string, never>;
export interface operations {
    get_healthz: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description is the server alive */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Health"];
                };
            };
            400: components["responses"]["Problem400"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_metrics: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description what lines and server do, for Prometheus (text format 0.0.4) */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "text/plain": string;
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_api_openapi_json: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description this description */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["OpenApi"];
                };
            };
            400: components["responses"]["Problem400"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_page: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description the page */
            200: {
                headers: {
                    /** @description what a browser that shows it may load */
                    "Content-Security-Policy": string;
                    /** @description of what is there now, quoted; the revision where a change asks for it in `If-Match` */
                    ETag: string;
                    /** @description the headers of the request that decide on it */
                    Vary: string;
                    [name: string]: unknown;
                };
                content: {
                    "text/html": string;
                };
            };
            400: components["responses"]["Problem400"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_assets_name: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description of the file */
                name: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description a file of the page */
            200: {
                headers: {
                    /** @description what a browser that shows it may load */
                    "Content-Security-Policy": string;
                    /** @description of what is there now, quoted; the revision where a change asks for it in `If-Match` */
                    ETag: string;
                    /** @description the headers of the request that decide on it */
                    Vary: string;
                    [name: string]: unknown;
                };
                content: {
                    "text/html": string;
                    "text/javascript": string;
                    "text/css": string;
                    "image/svg+xml": string;
                    "image/png": string;
                    "font/woff2": string;
                    "application/manifest+json": string;
                    "application/json": string;
                    "application/octet-stream": string;
                };
            };
            400: components["responses"]["Problem400"];
            404: components["responses"]["Problem404"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_docs: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description the documentation */
            200: {
                headers: {
                    /** @description what a browser that shows it may load */
                    "Content-Security-Policy": string;
                    /** @description of what is there now, quoted; the revision where a change asks for it in `If-Match` */
                    ETag: string;
                    /** @description the headers of the request that decide on it */
                    Vary: string;
                    [name: string]: unknown;
                };
                content: {
                    "text/html": string;
                };
            };
            400: components["responses"]["Problem400"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_docs_name: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description of the page */
                name: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description a page of the documentation, or its picture */
            200: {
                headers: {
                    /** @description what a browser that shows it may load */
                    "Content-Security-Policy": string;
                    /** @description of what is there now, quoted; the revision where a change asks for it in `If-Match` */
                    ETag: string;
                    /** @description the headers of the request that decide on it */
                    Vary: string;
                    [name: string]: unknown;
                };
                content: {
                    "text/html": string;
                    "image/png": string;
                };
            };
            400: components["responses"]["Problem400"];
            404: components["responses"]["Problem404"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_session: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description who am I */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Session"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_session: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["NewSession"];
            };
        };
        responses: {
            /** @description sign in with a token, or a name with a password or PIN; get a cookie */
            204: {
                headers: {
                    /** @description the cookie of a session, or of a sign-in: HttpOnly, SameSite=Strict */
                    "Set-Cookie": string;
                    [name: string]: unknown;
                };
                content?: never;
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            429: components["responses"]["Problem429"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    delete_session: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description sign out */
            204: {
                headers: {
                    /** @description the cookie of a session, or of a sign-in: HttpOnly, SameSite=Strict */
                    "Set-Cookie": string;
                    [name: string]: unknown;
                };
                content?: never;
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    put_session_password: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["OwnSecret"];
            };
        };
        responses: {
            /** @description a new password of one's own */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_session_provider: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description the OpenID Connect provider that people may sign in by, as its button has it */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["SignInProvider"];
                };
            };
            400: components["responses"]["Problem400"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_session_provider: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["ProviderAnswer"];
            };
        };
        responses: {
            /** @description sign in by what the provider sent back with the browser that began it; get a cookie */
            204: {
                headers: {
                    /** @description the cookie of a session, or of a sign-in: HttpOnly, SameSite=Strict */
                    "Set-Cookie": string;
                    [name: string]: unknown;
                };
                content?: never;
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            429: components["responses"]["Problem429"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_session_provider_begin: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description begin to sign in by the provider: the address that the browser opens, and a cookie that it keeps meanwhile */
            200: {
                headers: {
                    /** @description the cookie of a session, or of a sign-in: HttpOnly, SameSite=Strict */
                    "Set-Cookie": string;
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ProviderSignIn"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            429: components["responses"]["Problem429"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_events: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description live events, resumable (text/event-stream) */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "text/event-stream": string;
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            422: components["responses"]["Problem422"];
            429: components["responses"]["Problem429"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_mtconnect_probe: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description machines with their data items, for MTConnect (2.0) */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/xml": string;
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                    "application/xml": string;
                };
            };
        };
    };
    get_mtconnect_current: {
        parameters: {
            query?: {
                /** @description the number of the first change */
                from?: string;
                /** @description how many changes at most */
                count?: number;
                /** @description an XPath; not supported: refused as MTConnect prescribes */
                path?: string;
                /** @description a number in the past; not supported: refused as MTConnect prescribes */
                at?: string;
                /** @description of a stream; not supported: refused as MTConnect prescribes */
                interval?: string;
                /** @description of a stream; not supported: refused as MTConnect prescribes */
                heartbeat?: string;
            };
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description the newest value of each data item */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/xml": string;
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                    "application/xml": string;
                };
            };
        };
    };
    get_mtconnect_sample: {
        parameters: {
            query?: {
                /** @description the number of the first change */
                from?: string;
                /** @description how many changes at most */
                count?: number;
                /** @description an XPath; not supported: refused as MTConnect prescribes */
                path?: string;
                /** @description a number in the past; not supported: refused as MTConnect prescribes */
                at?: string;
                /** @description of a stream; not supported: refused as MTConnect prescribes */
                interval?: string;
                /** @description of a stream; not supported: refused as MTConnect prescribes */
                heartbeat?: string;
            };
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description changes of data items, from a number on */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/xml": string;
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                    "application/xml": string;
                };
            };
        };
    };
    get_mtconnect_assets: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description released programs as files */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/xml": string;
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                    "application/xml": string;
                };
            };
        };
    };
    get_mtconnect_name_probe: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description of the machine */
                name: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description one machine with its data items */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/xml": string;
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                    "application/xml": string;
                };
            };
        };
    };
    get_mtconnect_name_current: {
        parameters: {
            query?: {
                /** @description the number of the first change */
                from?: string;
                /** @description how many changes at most */
                count?: number;
                /** @description an XPath; not supported: refused as MTConnect prescribes */
                path?: string;
                /** @description a number in the past; not supported: refused as MTConnect prescribes */
                at?: string;
                /** @description of a stream; not supported: refused as MTConnect prescribes */
                interval?: string;
                /** @description of a stream; not supported: refused as MTConnect prescribes */
                heartbeat?: string;
            };
            header?: never;
            path: {
                /** @description of the machine */
                name: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description the newest values of one machine */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/xml": string;
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                    "application/xml": string;
                };
            };
        };
    };
    get_mtconnect_name_sample: {
        parameters: {
            query?: {
                /** @description the number of the first change */
                from?: string;
                /** @description how many changes at most */
                count?: number;
                /** @description an XPath; not supported: refused as MTConnect prescribes */
                path?: string;
                /** @description a number in the past; not supported: refused as MTConnect prescribes */
                at?: string;
                /** @description of a stream; not supported: refused as MTConnect prescribes */
                interval?: string;
                /** @description of a stream; not supported: refused as MTConnect prescribes */
                heartbeat?: string;
            };
            header?: never;
            path: {
                /** @description of the machine */
                name: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description changes of one machine, from a number on */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/xml": string;
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                    "application/xml": string;
                };
            };
        };
    };
    get_machines: {
        parameters: {
            query?: {
                /** @description how many a page has at most; not given: 50 */
                limit?: number;
                /** @description `next` of the page before */
                after?: string;
            };
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description machines with the state of their lines */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["MachineSummaryPage"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_machines: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["Profile"];
            };
        };
        responses: {
            /** @description add a machine by its profile */
            201: {
                headers: {
                    /** @description the path of what was made */
                    Location: string;
                    /** @description of what is there now, quoted; the revision where a change asks for it in `If-Match` */
                    ETag: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Machine"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_machines_name: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description of the machine */
                name: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description one machine with its profile */
            200: {
                headers: {
                    /** @description of what is there now, quoted; the revision where a change asks for it in `If-Match` */
                    ETag: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Machine"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    put_machines_name: {
        parameters: {
            query?: never;
            header: {
                /** @description the revision that is changed: the ETag of what was read */
                "If-Match": string;
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path: {
                /** @description of the machine */
                name: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["Profile"];
            };
        };
        responses: {
            /** @description change a profile */
            200: {
                headers: {
                    /** @description of what is there now, quoted; the revision where a change asks for it in `If-Match` */
                    ETag: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Machine"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            412: components["responses"]["Problem412"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            428: components["responses"]["Problem428"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_machines_name_utilisation: {
        parameters: {
            query?: {
                /** @description how many, back from now */
                days?: number;
            };
            header?: never;
            path: {
                /** @description of the machine */
                name: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description how its line was used, by days */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Utilisation"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_machines_name_wire: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description of the machine */
                name: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description what passes on its line from now on, in both directions (text/event-stream, events `wire`) */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "text/event-stream": string;
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            422: components["responses"]["Problem422"];
            429: components["responses"]["Problem429"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_machines_name_line_test: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path: {
                /** @description of the machine */
                name: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description measure its line with a loopback plug in the control's place; nothing is armed on it meanwhile */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["LineTest"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_machines_name_confirm_reset: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path: {
                /** @description of the machine */
                name: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["Reason"];
            };
        };
        responses: {
            /** @description a person confirms that the control was reset */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["MachineStatus"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_machines_name_hand_over: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path: {
                /** @description of the machine */
                name: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["HandOver"];
            };
        };
        responses: {
            /** @description give its line to another server of this store; nothing is on it */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["MachineStatus"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_machines_name_take_over: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path: {
                /** @description of the machine */
                name: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["Reason"];
            };
        };
        responses: {
            /** @description a person takes its line over from a server that no longer answers */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["MachineStatus"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_nodes: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description servers that share this store; none: this is the only one */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["NodePage"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_groups: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description groups of machines */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["MachineGroupPage"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    put_groups_name: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path: {
                /** @description of the group */
                name: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["GroupChange"];
            };
        };
        responses: {
            /** @description make a group of machines, or change it as a whole */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["MachineGroup"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    delete_groups_name: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path: {
                /** @description of the group */
                name: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description remove a group and what was granted in it */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_groups_name_jobs: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path: {
                /** @description of the group */
                name: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["NewChoice"];
            };
        };
        responses: {
            /** @description queue a program for the machines of a group: a choice of jobs of which a person arms one */
            201: {
                headers: {
                    /** @description the path of what was made */
                    Location: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["JobChoice"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_users: {
        parameters: {
            query?: {
                /** @description how many a page has at most; not given: 50 */
                limit?: number;
                /** @description `next` of the page before */
                after?: string;
            };
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description people */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["UserPage"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_users: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["NewUser"];
            };
        };
        responses: {
            /** @description add a person */
            201: {
                headers: {
                    /** @description the path of what was made */
                    Location: string;
                    /** @description of what is there now, quoted; the revision where a change asks for it in `If-Match` */
                    ETag: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["User"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_users_name: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description of the person */
                name: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description one person */
            200: {
                headers: {
                    /** @description of what is there now, quoted; the revision where a change asks for it in `If-Match` */
                    ETag: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["User"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    put_users_name: {
        parameters: {
            query?: never;
            header: {
                /** @description the revision that is changed: the ETag of what was read */
                "If-Match": string;
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path: {
                /** @description of the person */
                name: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["UserChange"];
            };
        };
        responses: {
            /** @description change roles, disable or enable */
            200: {
                headers: {
                    /** @description of what is there now, quoted; the revision where a change asks for it in `If-Match` */
                    ETag: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["User"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            412: components["responses"]["Problem412"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            428: components["responses"]["Problem428"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_users_name_unlock: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path: {
                /** @description of the person */
                name: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description end the lock after too many wrong secrets */
            200: {
                headers: {
                    /** @description of what is there now, quoted; the revision where a change asks for it in `If-Match` */
                    ETag: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["User"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    put_users_name_password: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description of the person */
                name: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["NewSecret"];
            };
        };
        responses: {
            /** @description give a person a new password; ends sessions */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    delete_users_name_password: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description of the person */
                name: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description take a password away; ends sessions */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    put_users_name_pin: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description of the person */
                name: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["NewSecret"];
            };
        };
        responses: {
            /** @description give a person a new PIN for the shop floor; ends sessions */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    delete_users_name_pin: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description of the person */
                name: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description take a PIN away; ends sessions */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_tokens: {
        parameters: {
            query?: {
                /** @description how many a page has at most; not given: 50 */
                limit?: number;
                /** @description `next` of the page before */
                after?: string;
            };
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description tokens, newest first, without their secrets */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["TokenPage"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_tokens: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["NewToken"];
            };
        };
        responses: {
            /** @description make a token; its secret is shown this once */
            201: {
                headers: {
                    /** @description the path of what was made */
                    Location: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["TokenMade"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_tokens_id: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description one token, without its secret */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Token"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    delete_tokens_id: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description end a token and its sessions */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_audit: {
        parameters: {
            query?: {
                /** @description how many a page has at most; not given: 50 */
                limit?: number;
                /** @description `next` of the page before */
                after?: string;
                /** @description only rows about this thing: "program/7" */
                subject?: string;
                /** @description only what this person or token did */
                actor?: string;
                /** @description only this kind of act */
                action?: string;
                /** @description from this time on, in ms since 1970, UTC */
                from_ms?: number;
                /** @description before this time, in ms since 1970, UTC */
                to_ms?: number;
            };
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description who did what, newest first */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["AuditRowPage"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_store: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description where the store is and what room it has */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["StoreRoom"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_store_verify: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description read the whole store through: the audit's chain, each ledger, each text by its hash */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["StoreVerification"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_backups: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description backups in the server's folder for them, newest first */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["BackupPage"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_backups: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description make a backup of the whole store while it runs; it is read back as a whole before it gets its name */
            201: {
                headers: {
                    /** @description the path of what was made */
                    Location: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["BackupMade"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    delete_backups_name: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path: {
                /** @description of the backup */
                name: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description remove a backup */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_families: {
        parameters: {
            query?: {
                /** @description how many a page has at most; not given: 50 */
                limit?: number;
                /** @description `next` of the page before */
                after?: string;
            };
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description part families */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["FamilySummaryPage"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_families: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["NewText"];
            };
        };
        responses: {
            /** @description add a family by its text */
            201: {
                headers: {
                    /** @description the path of what was made */
                    Location: string;
                    /** @description of what is there now, quoted; the revision where a change asks for it in `If-Match` */
                    ETag: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Family"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_families_name: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description of the family */
                name: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description one family with its text and parameters */
            200: {
                headers: {
                    /** @description of what is there now, quoted; the revision where a change asks for it in `If-Match` */
                    ETag: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Family"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    put_families_name: {
        parameters: {
            query?: never;
            header: {
                /** @description the revision that is changed: the ETag of what was read */
                "If-Match": string;
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path: {
                /** @description of the family */
                name: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["NewText"];
            };
        };
        responses: {
            /** @description a new revision of a family */
            200: {
                headers: {
                    /** @description of what is there now, quoted; the revision where a change asks for it in `If-Match` */
                    ETag: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Family"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            412: components["responses"]["Problem412"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            428: components["responses"]["Problem428"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_parts: {
        parameters: {
            query?: {
                /** @description how many a page has at most; not given: 50 */
                limit?: number;
                /** @description `next` of the page before */
                after?: string;
                /** @description only those of this family, by its name */
                family?: string;
            };
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description parts: families with values */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["PartPage"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_parts: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["NewPart"];
            };
        };
        responses: {
            /** @description add a part */
            201: {
                headers: {
                    /** @description the path of what was made */
                    Location: string;
                    /** @description of what is there now, quoted; the revision where a change asks for it in `If-Match` */
                    ETag: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Part"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_parts_number: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description of the part */
                number: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description one part */
            200: {
                headers: {
                    /** @description of what is there now, quoted; the revision where a change asks for it in `If-Match` */
                    ETag: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Part"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    put_parts_number: {
        parameters: {
            query?: never;
            header: {
                /** @description the revision that is changed: the ETag of what was read */
                "If-Match": string;
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path: {
                /** @description of the part */
                number: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["PartChange"];
            };
        };
        responses: {
            /** @description a new revision of a part's values */
            200: {
                headers: {
                    /** @description of what is there now, quoted; the revision where a change asks for it in `If-Match` */
                    ETag: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Part"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            412: components["responses"]["Problem412"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            428: components["responses"]["Problem428"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_programs: {
        parameters: {
            query?: {
                /** @description how many a page has at most; not given: 50 */
                limit?: number;
                /** @description `next` of the page before */
                after?: string;
                /** @description only programs with this name */
                name?: string;
                /** @description only those of this part, by its number */
                part?: string;
                /** @description only programs with this tag */
                tag?: string;
                /** @description only programs in this folder */
                folder?: string;
                /** @description programs in use, archived ones, or both */
                shelf?: "in_use" | "archived" | "all";
            };
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description programs */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ProgramPage"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_programs: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["NewProgram"];
            };
        };
        responses: {
            /** @description add a program by its text */
            201: {
                headers: {
                    /** @description the path of what was made */
                    Location: string;
                    /** @description of what is there now, quoted; the revision where a change asks for it in `If-Match` */
                    ETag: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Program"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_programs_id: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description one program */
            200: {
                headers: {
                    /** @description of what is there now, quoted; the revision where a change asks for it in `If-Match` */
                    ETag: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Program"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    patch_programs_id: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["ProgramLabels"];
            };
        };
        responses: {
            /** @description give a program tags and a folder */
            200: {
                headers: {
                    /** @description of what is there now, quoted; the revision where a change asks for it in `If-Match` */
                    ETag: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Program"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_programs_id_text: {
        parameters: {
            query?: {
                /** @description of the text; not given: the newest */
                revision?: number;
            };
            header?: never;
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description the text of a revision */
            200: {
                headers: {
                    /** @description of what is there now, quoted; the revision where a change asks for it in `If-Match` */
                    ETag: string;
                    [name: string]: unknown;
                };
                content: {
                    "text/plain": string;
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_programs_id_lines: {
        parameters: {
            query?: {
                /** @description of the text; not given: the newest */
                revision?: number;
                /** @description the first line, from 1 */
                from?: string;
                /** @description how many lines */
                count?: number;
            };
            header?: never;
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description some lines of a revision, each with the family's line and values that it was rendered from */
            200: {
                headers: {
                    /** @description of what is there now, quoted; the revision where a change asks for it in `If-Match` */
                    ETag: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ProgramLines"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_programs_id_revisions: {
        parameters: {
            query?: {
                /** @description how many a page has at most; not given: 50 */
                limit?: number;
                /** @description `next` of the page before */
                after?: string;
            };
            header?: never;
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description revisions, newest first */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ProgramRevisionPage"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_programs_id_revisions: {
        parameters: {
            query?: never;
            header: {
                /** @description the revision that is changed: the ETag of what was read */
                "If-Match": string;
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["NewText"];
            };
        };
        responses: {
            /** @description a new revision of the text */
            201: {
                headers: {
                    /** @description the path of what was made */
                    Location: string;
                    /** @description of what is there now, quoted; the revision where a change asks for it in `If-Match` */
                    ETag: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Program"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            412: components["responses"]["Problem412"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            428: components["responses"]["Problem428"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_programs_id_compare: {
        parameters: {
            query?: {
                /** @description id of the program that it is compared with; not given: the same one */
                with?: number;
                /** @description of the text; not given: the newest */
                revision?: number;
                /** @description of the text that it is compared with; not given: the newest */
                with_revision?: number;
                /** @description for which the motions are computed */
                machine?: string;
            };
            header?: never;
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description compare a revision with another one, or with another program's: text, meaning, motions */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Comparison"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_programs_id_compare: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["CompareText"];
            };
        };
        responses: {
            /** @description compare a text that is being written with a revision: text, meaning, motions; it is not stored */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Comparison"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_programs_id_path: {
        parameters: {
            query?: {
                /** @description of the text; not given: the newest */
                revision?: number;
                /** @description for which motions and times are computed; not given: no times */
                machine?: string;
                /** @description how the text would go to the control; not given: memory */
                delivery?: "drip" | "memory";
            };
            header?: never;
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description the toolpath of a revision, as points, and what is not known of it */
            200: {
                headers: {
                    /** @description of what is there now, quoted; the revision where a change asks for it in `If-Match` */
                    ETag: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ToolPath"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_programs_id_picture: {
        parameters: {
            query?: {
                /** @description of the text; not given: the newest */
                revision?: number;
            };
            header?: never;
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description a small drawing of a revision's toolpath, for a list */
            200: {
                headers: {
                    /** @description of what is there now, quoted; the revision where a change asks for it in `If-Match` */
                    ETag: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["PathPicture"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_programs_id_stock: {
        parameters: {
            query?: {
                /** @description of the text; not given: the newest */
                revision?: number;
                /** @description whose tools cut */
                machine?: string;
                /** @description how the text would go to the control; not given: memory */
                delivery?: "drip" | "memory";
                /** @description the blank as `box X0 X1 Y0 Y1 Z0 Z1` or `cylinder DIAMETER Z0 Z1`, in mm; not given: that of the family */
                stock?: string;
            };
            header?: never;
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description the stock of a revision from the first cut to the last, as columns of numbers that its head describes */
            200: {
                headers: {
                    /** @description of what is there now, quoted; the revision where a change asks for it in `If-Match` */
                    ETag: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/octet-stream": string;
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_programs_id_archive: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["Reason"];
            };
        };
        responses: {
            /** @description put a program aside, with a reason: it takes no revision and no release */
            200: {
                headers: {
                    /** @description of what is there now, quoted; the revision where a change asks for it in `If-Match` */
                    ETag: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Program"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_programs_id_fetch_back: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["Reason"];
            };
        };
        responses: {
            /** @description use an archived program again, with a reason */
            200: {
                headers: {
                    /** @description of what is there now, quoted; the revision where a change asks for it in `If-Match` */
                    ETag: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Program"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_programs_id_delete: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["Reason"];
            };
        };
        responses: {
            /** @description delete an archived program for good, with a reason; what releases, jobs and the ledger name of it stays */
            200: {
                headers: {
                    /** @description of what is there now, quoted; the revision where a change asks for it in `If-Match` */
                    ETag: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Program"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_programs_id_uses: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description which parts, releases, jobs, machines and other programs use a program, and which ones it calls */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ProgramUses"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_attachments: {
        parameters: {
            query?: {
                /** @description how many a page has at most; not given: 50 */
                limit?: number;
                /** @description `next` of the page before */
                after?: string;
                /** @description whose files, by its id */
                program?: number;
                /** @description whose files, by its name */
                family?: string;
                /** @description whose files, by its number */
                part?: string;
                /** @description whose files, by its id */
                order?: number;
            };
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description files that are attached: setup sheets, drawings, pictures; newest first, without those that were removed */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["AttachmentPage"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_attachments: {
        parameters: {
            query?: {
                /** @description of the file */
                name?: string;
                /** @description whose files, by its id */
                program?: number;
                /** @description whose files, by its name */
                family?: string;
                /** @description whose files, by its number */
                part?: string;
                /** @description whose files, by its id */
                order?: number;
            };
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path?: never;
            cookie?: never;
        };
        /** @description the bytes of the file */
        requestBody: {
            content: {
                "*/*": string;
            };
        };
        responses: {
            /** @description attach a file to one program, family, part or order; the body is the file, Content-Type its type */
            201: {
                headers: {
                    /** @description the path of what was made */
                    Location: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Attachment"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_attachments_id: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description one attached file, also one that was removed */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Attachment"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_attachments_id_content: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description the file itself, to be saved; its type, where that is one of a list of harmless ones */
            200: {
                headers: {
                    /** @description as a file, under its name (RFC 6266) */
                    "Content-Disposition": string;
                    /** @description what a browser that shows it may load */
                    "Content-Security-Policy": string;
                    /** @description of what is there now, quoted; the revision where a change asks for it in `If-Match` */
                    ETag: string;
                    [name: string]: unknown;
                };
                content: {
                    "*/*": string;
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_attachments_id_remove: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["Reason"];
            };
        };
        responses: {
            /** @description remove a file, with a reason; what it was stays known */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Attachment"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_search: {
        parameters: {
            query?: {
                /** @description how many a page has at most; not given: 50 */
                limit?: number;
                /** @description `next` of the page before */
                after?: string;
                /** @description the words that are looked for, or a "phrase" */
                q?: string;
                /** @description programs in use, archived ones, or both */
                shelf?: "in_use" | "all";
            };
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description programs by words: names, numbers, tags, part, machine, comments, text; best first */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["SearchResult"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_diagnose: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["DiagnoseOrder"];
            };
        };
        responses: {
            /** @description what the reader and the validator find in a text that is being written; it is neither run nor stored */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Diagnosed"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_imports: {
        parameters: {
            query?: {
                /** @description of the file: turning/O0012.nc; its folders become folders of the library, its name the program's */
                path?: string;
                /** @description the library's folder in which those of the path lie */
                folder?: string;
                /** @description of new programs; without it the one that each text looks like */
                dialect?: string;
                /** @description a name that is in use in its folder with another text gets a revision (revise, as without it), or is left alone */
                known?: "revise" | "skip";
                /** @description true: the name keeps an ending such as .NC, because another file of the folder differs by that alone */
                keep_ending?: "true";
                /** @description true: report what would become of it; nothing is stored */
                only_look?: "true";
            };
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path?: never;
            cookie?: never;
        };
        /** @description the bytes of the file */
        requestBody?: {
            content: {
                "*/*": string;
            };
        };
        responses: {
            /** @description take one file into the library: a program, or the memory of a control with many; the body is the file */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ImportReport"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_split: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["NewText"];
            };
        };
        responses: {
            /** @description the programs of a text that holds several, as controls dump their memory; they are not stored */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["SplitText"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_convert: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["ConvertOrder"];
            };
        };
        responses: {
            /** @description a text or stored program in another control's language, run on both sides where it can be; it is not stored */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Converted"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_optimize: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["OptimizeOrder"];
            };
        };
        responses: {
            /** @description a text or stored program made faster for its control, with the same moves; it is not stored */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Optimized"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_rewrite: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["RewriteOrder"];
            };
        };
        responses: {
            /** @description a text that is being written with other block numbers, blanks or letters: the same program, or refused; it is not stored */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Rewritten"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_path: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["PathOrder"];
            };
        };
        responses: {
            /** @description the toolpath of a text that is being written; it is not stored */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ToolPath"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_stock: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["PathOrder"];
            };
        };
        responses: {
            /** @description the stock of a text that is being written from the first cut to the last, as columns of numbers; it is not stored */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/octet-stream": string;
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_statistics: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["DiagnoseOrder"];
            };
        };
        responses: {
            /** @description how far and, on a machine, how long the tools of a text move; it is not stored */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Statistics"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_dialects_name_words: {
        parameters: {
            query?: {
                /** @description of the machine: some words are of one kind alone */
                kind?: "mill" | "lathe" | "mill-turn";
                /** @description the G-code system of a lathe */
                g_system?: "A" | "B" | "C";
            };
            header?: never;
            path: {
                /** @description of the dialect */
                name: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description codes, keywords, functions, cycles and system variables of a dialect, each with a few words on it */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["DialectWords"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_render: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["RenderOrder"];
            };
        };
        responses: {
            /** @description render a part or family for a machine and store the program */
            201: {
                headers: {
                    /** @description the path of what was made */
                    Location: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Rendered"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_preview: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["RenderOrder"];
            };
        };
        responses: {
            /** @description what rendering would give, stored nowhere */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Preview"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_preview_verdict: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["RenderOrder"];
            };
        };
        responses: {
            /** @description what a check of the program that rendering would give finds, stored nowhere */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["PreviewVerdict"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_checks: {
        parameters: {
            query?: {
                /** @description how many a page has at most; not given: 50 */
                limit?: number;
                /** @description `next` of the page before */
                after?: string;
                /** @description only those of this program, by its id */
                program?: number;
                /** @description only those of this machine */
                machine?: string;
            };
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description verdicts, newest first */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["VerdictSummaryPage"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_checks: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["CheckOrder"];
            };
        };
        responses: {
            /** @description check a program for a machine and store the verdict */
            201: {
                headers: {
                    /** @description the path of what was made */
                    Location: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Verdict"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_checks_id: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description one verdict with its report */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Verdict"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_checks_id_waivers: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["NewWaiver"];
            };
        };
        responses: {
            /** @description waive a verdict or one point of it, with a reason; it may end by itself */
            201: {
                headers: {
                    /** @description the path of what was made */
                    Location: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Verdict"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_accuracy: {
        parameters: {
            query?: {
                /** @description the answer is this picture, as SVG */
                plot?: "deviation";
            };
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["AccuracyOrder"];
            };
        };
        responses: {
            /** @description how far a program's surface lies from the nominal, and measured points; with plot=deviation as SVG */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["AccuracyFigures"];
                    "image/svg+xml": string;
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_gouge: {
        parameters: {
            query?: {
                /** @description the answer is this picture, as SVG */
                plot?: "stock";
            };
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["GougeOrder"];
            };
        };
        responses: {
            /** @description a program's rapids into stock or part and cuts below the nominal; with plot=stock as SVG */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["GougeFigures"];
                    "image/svg+xml": string;
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_timing: {
        parameters: {
            query?: {
                /** @description the answer is this picture, as SVG */
                plot?: "feed" | "buffer";
            };
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["TimingOrder"];
            };
        };
        responses: {
            /** @description how long a program takes on a machine and its line; with plot=feed or plot=buffer as SVG */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["TimingFigures"];
                    "image/svg+xml": string;
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_sweep: {
        parameters: {
            query?: {
                /** @description the answer is this picture, as SVG */
                plot?: "region";
            };
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["SweepOrder"];
            };
        };
        responses: {
            /** @description for which values a family passes on a machine, and the smallest failure; with plot=region as SVG */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["SweepFigures"];
                    "image/svg+xml": string;
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_work: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description heavy work that waits or runs now, in the order in which it came */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["WorkPage"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    delete_work_id: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description cancel it: only the person who asked for it, or an admin */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_releases: {
        parameters: {
            query?: {
                /** @description how many a page has at most; not given: 50 */
                limit?: number;
                /** @description `next` of the page before */
                after?: string;
                /** @description only those of this program, by its id */
                program?: number;
                /** @description only those of this machine */
                machine?: string;
            };
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description releases, newest first */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ReleasePage"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_releases: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["NewRelease"];
            };
        };
        responses: {
            /** @description a draft that binds text, machine and delivery */
            201: {
                headers: {
                    /** @description the path of what was made */
                    Location: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Release"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_releases_id: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description one release */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Release"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_releases_id_transitions: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["ReleaseMove"];
            };
        };
        responses: {
            /** @description move a release on; a programmer hands it in for review, all else is an approver's */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Release"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_releases_id_sign_off: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["SignOff"];
            };
        };
        responses: {
            /** @description an operator signs off what the transfers of a proving have shown; an approver approves it after that */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Release"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_releases_id_restart_preview: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["RestartOrder"];
            };
        };
        responses: {
            /** @description the restart of the released text at a line, and what it assumes; stored nowhere */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["RestartPreview"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_releases_id_restarts: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["NewRestart"];
            };
        };
        responses: {
            /** @description a release in review of the restart that was shown; an approver releases it for one transfer */
            201: {
                headers: {
                    /** @description the path of what was made */
                    Location: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Release"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_orders: {
        parameters: {
            query?: {
                /** @description how many a page has at most; not given: 50 */
                limit?: number;
                /** @description `next` of the page before */
                after?: string;
                /** @description only orders with this number */
                number?: string;
                /** @description only those of this part, by its number */
                part?: string;
                /** @description only those of this machine */
                machine?: string;
                /** @description only those in this state */
                state?: "open" | "held" | "done" | "cancelled";
            };
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description what is to be made, newest first */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["OrderPage"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_orders: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["NewOrder"];
            };
        };
        responses: {
            /** @description add an order; the same number, operation and plan again is the same order */
            201: {
                headers: {
                    /** @description the path of what was made */
                    Location: string;
                    /** @description of what is there now, quoted; the revision where a change asks for it in `If-Match` */
                    ETag: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Order"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_orders_id: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description one order */
            200: {
                headers: {
                    /** @description of what is there now, quoted; the revision where a change asks for it in `If-Match` */
                    ETag: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Order"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    put_orders_id: {
        parameters: {
            query?: never;
            header: {
                /** @description the revision that is changed: the ETag of what was read */
                "If-Match": string;
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["OrderPlan"];
            };
        };
        responses: {
            /** @description change the plan of an order */
            200: {
                headers: {
                    /** @description of what is there now, quoted; the revision where a change asks for it in `If-Match` */
                    ETag: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Order"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            412: components["responses"]["Problem412"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            428: components["responses"]["Problem428"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_orders_id_move: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["OrderMove"];
            };
        };
        responses: {
            /** @description hold, open, close or cancel an order; while it is not open, none of its jobs is armed */
            200: {
                headers: {
                    /** @description of what is there now, quoted; the revision where a change asks for it in `If-Match` */
                    ETag: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Order"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_orders_id_parts: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["PartsReport"];
            };
        };
        responses: {
            /** @description report parts that were made */
            200: {
                headers: {
                    /** @description of what is there now, quoted; the revision where a change asks for it in `If-Match` */
                    ETag: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Order"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_jobs: {
        parameters: {
            query?: {
                /** @description how many a page has at most; not given: 50 */
                limit?: number;
                /** @description `next` of the page before */
                after?: string;
                /** @description only those of this machine */
                machine?: string;
                /** @description only those in this state */
                state?: "queued" | "armed" | "feeding" | "held" | "draining" | "done" | "failed" | "cancelled" | "interrupted";
                /** @description only those of this order, by its id */
                order?: number;
                /** @description only those of this choice, by its id */
                choice?: number;
            };
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description transfers, newest first */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["JobPage"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_jobs: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["NewJob"];
            };
        };
        responses: {
            /** @description queue a released program */
            201: {
                headers: {
                    /** @description the path of what was made */
                    Location: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Job"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_jobs_id: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description one job */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Job"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_jobs_id_forecast: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description how long its program takes by its verdict, line by line, and what the control's buffer holds */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["JobForecast"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_jobs_id_arm: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody?: {
            content: {
                "application/json": components["schemas"]["ArmOrder"];
            };
        };
        responses: {
            /** @description a person arms the job for its machine's line */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Job"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_jobs_id_move: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["Move"];
            };
        };
        responses: {
            /** @description move a queued job before another one, or to the end */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Job"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_jobs_id_schedule: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["JobSchedule"];
            };
        };
        responses: {
            /** @description when a queued job may be armed; nothing is armed by it */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Job"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_jobs_id_hold: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["Reason"];
            };
        };
        responses: {
            /** @description put a queued job on hold: it keeps its place and is not armed */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Job"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_jobs_id_end_hold: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description take a queued job off hold */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Job"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_jobs_id_retry: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description queue the release of a job that ended again, for the same order and with the same confirmation of its end */
            201: {
                headers: {
                    /** @description the path of what was made */
                    Location: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Job"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_jobs_id_confirm_end: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody?: {
            content: {
                "application/json": components["schemas"]["JobEnd"];
            };
        };
        responses: {
            /** @description a person confirms what the end of a job asks for, before the next one of the machine is armed */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Job"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_jobs_id_stop_reasons: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description why a job stood still or broke off, as people stated it */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["JobStopReasons"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_jobs_id_stop_reasons: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["NewStopReason"];
            };
        };
        responses: {
            /** @description state why a job stood still or broke off; it changes nothing else */
            201: {
                headers: {
                    /** @description the path of what was made */
                    Location: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["StopReason"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_jobs_id_stop: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description stop at a block end */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Job"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_jobs_id_cancel: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description end at a block end */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Job"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_jobs_id_resume: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody?: {
            content: {
                "application/json": components["schemas"]["OptionalReason"];
            };
        };
        responses: {
            /** @description go on; as if DC1 had come, with a reason */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Job"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_history_sums: {
        parameters: {
            query?: {
                /** @description what the sums are grouped by; not given: the machine */
                by?: "machine" | "part" | "day" | "shift";
                /** @description only those of this machine */
                machine?: string;
                /** @description only those in this state */
                state?: "done" | "failed" | "cancelled" | "interrupted";
                /** @description from this time on, in ms since 1970, UTC */
                from_ms?: number;
                /** @description before this time, in ms since 1970, UTC */
                to_ms?: number;
            };
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description sums of the transfers that ended in a time: durations, holds, line use, forecasts; as CSV where the request accepts that */
            200: {
                headers: {
                    /** @description the headers of the request that decide on it */
                    Vary: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HistorySums"];
                    "text/csv": string;
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_stop_reasons: {
        parameters: {
            query?: {
                /** @description only those of this machine */
                machine?: string;
                /** @description from this time on, in ms since 1970, UTC */
                from_ms?: number;
                /** @description before this time, in ms since 1970, UTC */
                to_ms?: number;
            };
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description which reasons of a stop there are, and how often each was stated in a time */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["StopReasonCounts"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_alarms: {
        parameters: {
            query?: {
                /** @description how many a page has at most; not given: 50 */
                limit?: number;
                /** @description `next` of the page before */
                after?: string;
                /** @description only those in this state */
                state?: "open" | "all";
                /** @description only those of this machine */
                machine?: string;
            };
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description alarms, newest first; with state=open those that ask for a person */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["AlarmPage"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_alarms_id: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description one alarm */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Alarm"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_alarms_id_acknowledge: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description a person acknowledges it */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Alarm"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_alarms_id_shelve: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["Shelve"];
            };
        };
        responses: {
            /** @description it asks for no person for some minutes, with a reason; not a critical one */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Alarm"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_alarms_id_unshelve: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description it asks again */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Alarm"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_event_types: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description events that are sent to other systems by webhooks and MQTT */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["OutboundTypePage"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_webhooks: {
        parameters: {
            query?: {
                /** @description how many a page has at most; not given: 50 */
                limit?: number;
                /** @description `next` of the page before */
                after?: string;
            };
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description who receives events by HTTP, newest first */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["WebhookPage"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_webhooks: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["NewWebhook"];
            };
        };
        responses: {
            /** @description post events to a URL from now on (Standard Webhooks 1.0); its secret is shown here and never again */
            201: {
                headers: {
                    /** @description the path of what was made */
                    Location: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["WebhookSecret"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_webhooks_id: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description one webhook, without its secret */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Webhook"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    delete_webhooks_id: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description remove a webhook with its deliveries */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    patch_webhooks_id: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["ChangedWebhook"];
            };
        };
        responses: {
            /** @description change the given members of a webhook */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Webhook"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_webhooks_id_rotate: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody?: {
            content: {
                "application/json": components["schemas"]["Rotate"];
            };
        };
        responses: {
            /** @description a new secret, shown once; the previous one also signs for some hours */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["WebhookSecret"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_webhooks_id_ping: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description send it an event webhook.ping, to try it */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["WebhookDelivery"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_webhooks_id_deliveries: {
        parameters: {
            query?: {
                /** @description how many a page has at most; not given: 50 */
                limit?: number;
                /** @description `next` of the page before */
                after?: string;
                /** @description only those in this state */
                state?: "pending" | "delivered" | "dead";
            };
            header?: never;
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description events that are being delivered to it, newest first */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["WebhookDeliveryPage"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_webhooks_id_deliveries_delivery_replay: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path: {
                /** @description of the thing, as its list states it */
                id: string;
                /** @description id of the delivery */
                delivery: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description send one again, with the same webhook-id */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["WebhookDelivery"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_webhooks_id_replay: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["Replay"];
            };
        };
        responses: {
            /** @description send all dead ones again whose event is not older */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Replayed"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_receipts: {
        parameters: {
            query?: {
                /** @description how many a page has at most; not given: 50 */
                limit?: number;
                /** @description `next` of the page before */
                after?: string;
                /** @description only those of this machine */
                machine?: string;
                /** @description only those in this state */
                state?: "stored" | "quarantined" | "accepted" | "discarded";
            };
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description what controls punched, newest first */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ReceiptPage"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_receipts_id: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description one receipt, compared with the stored program of its name */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Receipt"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_receipts_id_text: {
        parameters: {
            query?: {
                /** @description `read`: what can be read of the bytes, as text */
                form?: "read";
            };
            header?: never;
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description its text; of one in quarantine the bytes, or with form=read their text */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "text/plain": string;
                    "application/octet-stream": string;
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_receipts_id_explain: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description which values of the part make its family give the received text; they are rendered and compared */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ReceivedValues"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_receipts_id_accept: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody?: {
            content: {
                "application/json": components["schemas"]["AcceptOrder"];
            };
        };
        responses: {
            /** @description make it a program's revision; one in quarantine by an approver, with a reason */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Receipt"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            412: components["responses"]["Problem412"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    post_receipts_id_discard: {
        parameters: {
            query?: never;
            header?: {
                /** @description any text of the caller's: the same request with the same key takes effect once, and is answered as the first time */
                "Idempotency-Key"?: string;
            };
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["Reason"];
            };
        };
        responses: {
            /** @description it is not wanted, with a reason */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Receipt"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            409: components["responses"]["Problem409"];
            413: components["responses"]["Problem413"];
            415: components["responses"]["Problem415"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            507: components["responses"]["Problem507"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_requests: {
        parameters: {
            query?: {
                /** @description how many a page has at most; not given: 50 */
                limit?: number;
                /** @description `next` of the page before */
                after?: string;
                /** @description only those of this machine */
                machine?: string;
            };
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description what operators asked for, newest first */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["OperatorRequestPage"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_jobs_id_ledger: {
        parameters: {
            query?: {
                /** @description how many a page has at most; not given: 50 */
                limit?: number;
                /** @description `next` of the page before */
                after?: string;
            };
            header?: never;
            path: {
                /** @description of the thing, as its list states it */
                id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description what is known of a transfer */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Ledger"];
                };
            };
            400: components["responses"]["Problem400"];
            401: components["responses"]["Problem401"];
            403: components["responses"]["Problem403"];
            404: components["responses"]["Problem404"];
            422: components["responses"]["Problem422"];
            500: components["responses"]["Problem500"];
            503: components["responses"]["Problem503"];
            /** @description another problem */
            default: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
        };
    };
    webhook_program_added: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/cloudevents+json": components["schemas"]["ProgramEvent"];
            };
        };
        responses: {
            /** @description gone: the webhook is disabled */
            410: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description taken; all else is tried again */
            "2XX": {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
        };
    };
    webhook_program_revised: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/cloudevents+json": components["schemas"]["ProgramEvent"];
            };
        };
        responses: {
            /** @description gone: the webhook is disabled */
            410: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description taken; all else is tried again */
            "2XX": {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
        };
    };
    webhook_program_archived: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/cloudevents+json": components["schemas"]["ProgramEvent"];
            };
        };
        responses: {
            /** @description gone: the webhook is disabled */
            410: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description taken; all else is tried again */
            "2XX": {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
        };
    };
    webhook_program_fetched_back: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/cloudevents+json": components["schemas"]["ProgramEvent"];
            };
        };
        responses: {
            /** @description gone: the webhook is disabled */
            410: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description taken; all else is tried again */
            "2XX": {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
        };
    };
    webhook_program_deleted: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/cloudevents+json": components["schemas"]["ProgramEvent"];
            };
        };
        responses: {
            /** @description gone: the webhook is disabled */
            410: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description taken; all else is tried again */
            "2XX": {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
        };
    };
    webhook_order_added: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/cloudevents+json": components["schemas"]["OrderEvent"];
            };
        };
        responses: {
            /** @description gone: the webhook is disabled */
            410: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description taken; all else is tried again */
            "2XX": {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
        };
    };
    webhook_order_changed: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/cloudevents+json": components["schemas"]["OrderEvent"];
            };
        };
        responses: {
            /** @description gone: the webhook is disabled */
            410: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description taken; all else is tried again */
            "2XX": {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
        };
    };
    webhook_order_parts: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/cloudevents+json": components["schemas"]["OrderEvent"];
            };
        };
        responses: {
            /** @description gone: the webhook is disabled */
            410: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description taken; all else is tried again */
            "2XX": {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
        };
    };
    webhook_order_open: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/cloudevents+json": components["schemas"]["OrderEvent"];
            };
        };
        responses: {
            /** @description gone: the webhook is disabled */
            410: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description taken; all else is tried again */
            "2XX": {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
        };
    };
    webhook_order_held: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/cloudevents+json": components["schemas"]["OrderEvent"];
            };
        };
        responses: {
            /** @description gone: the webhook is disabled */
            410: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description taken; all else is tried again */
            "2XX": {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
        };
    };
    webhook_order_done: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/cloudevents+json": components["schemas"]["OrderEvent"];
            };
        };
        responses: {
            /** @description gone: the webhook is disabled */
            410: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description taken; all else is tried again */
            "2XX": {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
        };
    };
    webhook_order_cancelled: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/cloudevents+json": components["schemas"]["OrderEvent"];
            };
        };
        responses: {
            /** @description gone: the webhook is disabled */
            410: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description taken; all else is tried again */
            "2XX": {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
        };
    };
    webhook_release_draft: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/cloudevents+json": components["schemas"]["ReleaseEvent"];
            };
        };
        responses: {
            /** @description gone: the webhook is disabled */
            410: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description taken; all else is tried again */
            "2XX": {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
        };
    };
    webhook_release_in_review: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/cloudevents+json": components["schemas"]["ReleaseEvent"];
            };
        };
        responses: {
            /** @description gone: the webhook is disabled */
            410: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description taken; all else is tried again */
            "2XX": {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
        };
    };
    webhook_release_proving: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/cloudevents+json": components["schemas"]["ReleaseEvent"];
            };
        };
        responses: {
            /** @description gone: the webhook is disabled */
            410: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description taken; all else is tried again */
            "2XX": {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
        };
    };
    webhook_release_signed_off: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/cloudevents+json": components["schemas"]["ReleaseEvent"];
            };
        };
        responses: {
            /** @description gone: the webhook is disabled */
            410: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description taken; all else is tried again */
            "2XX": {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
        };
    };
    webhook_release_approved: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/cloudevents+json": components["schemas"]["ReleaseEvent"];
            };
        };
        responses: {
            /** @description gone: the webhook is disabled */
            410: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description taken; all else is tried again */
            "2XX": {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
        };
    };
    webhook_release_obsolete: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/cloudevents+json": components["schemas"]["ReleaseEvent"];
            };
        };
        responses: {
            /** @description gone: the webhook is disabled */
            410: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description taken; all else is tried again */
            "2XX": {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
        };
    };
    webhook_job_queued: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/cloudevents+json": components["schemas"]["JobEvent"];
            };
        };
        responses: {
            /** @description gone: the webhook is disabled */
            410: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description taken; all else is tried again */
            "2XX": {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
        };
    };
    webhook_job_armed: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/cloudevents+json": components["schemas"]["JobEvent"];
            };
        };
        responses: {
            /** @description gone: the webhook is disabled */
            410: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description taken; all else is tried again */
            "2XX": {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
        };
    };
    webhook_job_feeding: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/cloudevents+json": components["schemas"]["JobEvent"];
            };
        };
        responses: {
            /** @description gone: the webhook is disabled */
            410: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description taken; all else is tried again */
            "2XX": {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
        };
    };
    webhook_job_done: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/cloudevents+json": components["schemas"]["JobEvent"];
            };
        };
        responses: {
            /** @description gone: the webhook is disabled */
            410: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description taken; all else is tried again */
            "2XX": {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
        };
    };
    webhook_job_failed: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/cloudevents+json": components["schemas"]["JobEvent"];
            };
        };
        responses: {
            /** @description gone: the webhook is disabled */
            410: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description taken; all else is tried again */
            "2XX": {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
        };
    };
    webhook_job_cancelled: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/cloudevents+json": components["schemas"]["JobEvent"];
            };
        };
        responses: {
            /** @description gone: the webhook is disabled */
            410: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description taken; all else is tried again */
            "2XX": {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
        };
    };
    webhook_job_interrupted: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/cloudevents+json": components["schemas"]["JobEvent"];
            };
        };
        responses: {
            /** @description gone: the webhook is disabled */
            410: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description taken; all else is tried again */
            "2XX": {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
        };
    };
    webhook_job_scheduled: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/cloudevents+json": components["schemas"]["JobPlanEvent"];
            };
        };
        responses: {
            /** @description gone: the webhook is disabled */
            410: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description taken; all else is tried again */
            "2XX": {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
        };
    };
    webhook_job_on_hold: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/cloudevents+json": components["schemas"]["JobPlanEvent"];
            };
        };
        responses: {
            /** @description gone: the webhook is disabled */
            410: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description taken; all else is tried again */
            "2XX": {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
        };
    };
    webhook_job_off_hold: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/cloudevents+json": components["schemas"]["JobPlanEvent"];
            };
        };
        responses: {
            /** @description gone: the webhook is disabled */
            410: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description taken; all else is tried again */
            "2XX": {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
        };
    };
    webhook_job_end_confirmed: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/cloudevents+json": components["schemas"]["JobPlanEvent"];
            };
        };
        responses: {
            /** @description gone: the webhook is disabled */
            410: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description taken; all else is tried again */
            "2XX": {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
        };
    };
    webhook_job_stop_reason: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/cloudevents+json": components["schemas"]["JobStopEvent"];
            };
        };
        responses: {
            /** @description gone: the webhook is disabled */
            410: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description taken; all else is tried again */
            "2XX": {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
        };
    };
    webhook_line_disconnected: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/cloudevents+json": components["schemas"]["LineEvent"];
            };
        };
        responses: {
            /** @description gone: the webhook is disabled */
            410: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description taken; all else is tried again */
            "2XX": {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
        };
    };
    webhook_line_idle: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/cloudevents+json": components["schemas"]["LineEvent"];
            };
        };
        responses: {
            /** @description gone: the webhook is disabled */
            410: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description taken; all else is tried again */
            "2XX": {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
        };
    };
    webhook_line_armed: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/cloudevents+json": components["schemas"]["LineEvent"];
            };
        };
        responses: {
            /** @description gone: the webhook is disabled */
            410: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description taken; all else is tried again */
            "2XX": {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
        };
    };
    webhook_line_feeding: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/cloudevents+json": components["schemas"]["LineEvent"];
            };
        };
        responses: {
            /** @description gone: the webhook is disabled */
            410: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description taken; all else is tried again */
            "2XX": {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
        };
    };
    webhook_line_held: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/cloudevents+json": components["schemas"]["LineEvent"];
            };
        };
        responses: {
            /** @description gone: the webhook is disabled */
            410: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description taken; all else is tried again */
            "2XX": {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
        };
    };
    webhook_line_draining: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/cloudevents+json": components["schemas"]["LineEvent"];
            };
        };
        responses: {
            /** @description gone: the webhook is disabled */
            410: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description taken; all else is tried again */
            "2XX": {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
        };
    };
    webhook_line_torn: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/cloudevents+json": components["schemas"]["LineEvent"];
            };
        };
        responses: {
            /** @description gone: the webhook is disabled */
            410: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description taken; all else is tried again */
            "2XX": {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
        };
    };
    webhook_line_receiving: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/cloudevents+json": components["schemas"]["LineEvent"];
            };
        };
        responses: {
            /** @description gone: the webhook is disabled */
            410: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description taken; all else is tried again */
            "2XX": {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
        };
    };
    webhook_line_answering: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/cloudevents+json": components["schemas"]["LineEvent"];
            };
        };
        responses: {
            /** @description gone: the webhook is disabled */
            410: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description taken; all else is tried again */
            "2XX": {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
        };
    };
    webhook_alarm_raised: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/cloudevents+json": components["schemas"]["AlarmEvent"];
            };
        };
        responses: {
            /** @description gone: the webhook is disabled */
            410: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description taken; all else is tried again */
            "2XX": {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
        };
    };
    webhook_alarm_cleared: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/cloudevents+json": components["schemas"]["AlarmEvent"];
            };
        };
        responses: {
            /** @description gone: the webhook is disabled */
            410: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description taken; all else is tried again */
            "2XX": {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
        };
    };
    webhook_alarm_acknowledged: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/cloudevents+json": components["schemas"]["AlarmEvent"];
            };
        };
        responses: {
            /** @description gone: the webhook is disabled */
            410: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description taken; all else is tried again */
            "2XX": {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
        };
    };
    webhook_alarm_shelved: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/cloudevents+json": components["schemas"]["AlarmEvent"];
            };
        };
        responses: {
            /** @description gone: the webhook is disabled */
            410: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description taken; all else is tried again */
            "2XX": {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
        };
    };
    webhook_alarm_unshelved: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/cloudevents+json": components["schemas"]["AlarmEvent"];
            };
        };
        responses: {
            /** @description gone: the webhook is disabled */
            410: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description taken; all else is tried again */
            "2XX": {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
        };
    };
    webhook_receipt_stored: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/cloudevents+json": components["schemas"]["ReceiptEvent"];
            };
        };
        responses: {
            /** @description gone: the webhook is disabled */
            410: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description taken; all else is tried again */
            "2XX": {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
        };
    };
    webhook_receipt_quarantined: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/cloudevents+json": components["schemas"]["ReceiptEvent"];
            };
        };
        responses: {
            /** @description gone: the webhook is disabled */
            410: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description taken; all else is tried again */
            "2XX": {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
        };
    };
    webhook_receipt_accepted: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/cloudevents+json": components["schemas"]["ReceiptEvent"];
            };
        };
        responses: {
            /** @description gone: the webhook is disabled */
            410: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description taken; all else is tried again */
            "2XX": {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
        };
    };
    webhook_receipt_discarded: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/cloudevents+json": components["schemas"]["ReceiptEvent"];
            };
        };
        responses: {
            /** @description gone: the webhook is disabled */
            410: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description taken; all else is tried again */
            "2XX": {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
        };
    };
    webhook_webhook_ping: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/cloudevents+json": components["schemas"]["WebhookEvent"];
            };
        };
        responses: {
            /** @description gone: the webhook is disabled */
            410: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description taken; all else is tried again */
            "2XX": {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
        };
    };
}
