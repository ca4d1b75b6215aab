import type { MessageView } from "../core/protocol/MessageView";
import { t } from "../i18n";

interface MessagesProps {
  messages: readonly MessageView[];
  isChanged: boolean;
  status: string | undefined;
  onLine(line: number): void;
}

/** What the last run said; a line that it names can be gone to. */
export function Messages({ messages, isChanged, status, onLine }: MessagesProps) {
  return (
    <section className="messages" role="log" aria-label={t("script.messages")} tabIndex={0}>
      {messages.length === 0 && (
        <p className="faint">{t(isChanged || status === undefined || status !== "ok" ? "script.status.waits" : "script.status.ok")}</p>
      )}
      {messages.map(({ level, text, line }, at) => (
        <p key={at} className={level}>
          {line !== undefined && (
            <button type="button" onClick={() => onLine(line)}>
              {t("script.line", { line })}
            </button>
          )}
          <span>{text}</span>
        </p>
      ))}
    </section>
  );
}
