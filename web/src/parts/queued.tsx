// What was just queued, and where it is armed: each job, and the machines that a choice left out.
import type { JobChoice } from '../api/types';
import { t } from '../i18n/i18n';
import { hrefs } from '../router';

export type Queued = Pick<JobChoice, 'jobs' | 'left_out'>;

export const WhatWasQueued = ({ of }: { of: Queued }) => (
  <div class="notice tone-good" role="status">
    {of.jobs.map((job) => (
      <p key={job.id}>
        {t('releases.queued', { job: job.id })} <a href={hrefs.machine(job.machine)}>{t('releases.go', { machine: job.machine })}</a>
      </p>
    ))}
    {of.jobs.length > 1 && <p>{t('releases.choice')}</p>}
    {of.left_out.map(({ machine, why }) => (
      <p key={machine}>{t('releases.left_out', { machine, why })}</p>
    ))}
  </div>
);
