// Webhooks in the database, and how events become deliveries. The deliveries themselves: delivery_rows.
#pragma once

#include "store/sql/database.h"
#include "store/webhooks.h"

namespace dripfeed::sql {

class WebhookTable final : public store::Webhooks {
 public:
  explicit WebhookTable(Database& database) : database_(database) {}
  store::Result<store::Webhook> add(const store::WebhookSettings& settings, std::string_view secret, std::uint64_t most,
                                    const store::Stamp& by) override;
  store::Result<store::Webhook> change(store::Id webhook, const store::WebhookSettings& settings,
                                       const store::Stamp& by) override;
  store::Result<store::Webhook> rotate(store::Id webhook, std::string_view secret, std::int64_t old_until_ms,
                                       const store::Stamp& by) override;
  store::Result<store::Webhook> disable(store::Id webhook, std::string_view why, const store::Stamp& by) override;
  store::Result<void> remove(store::Id webhook, const store::Stamp& by) override;
  store::Result<store::Webhook> get(store::Id webhook) override;
  store::Result<store::Page<store::Webhook>> list(const store::PageRequest& page) override;
  store::Result<std::vector<store::Webhook>> enabled() override;
  store::Result<std::uint64_t> take_new(std::int64_t now_ms, std::uint64_t most_pending) override;
  store::Result<store::WebhookDelivery> ping(store::Id webhook, const store::Stamp& by) override;
  store::Result<std::optional<store::WebhookDelivery>> due(store::Id webhook, std::int64_t now_ms) override;
  store::Result<void> note_try(store::Id delivery, const store::DeliveryTry& tried) override;
  store::Result<store::WebhookDelivery> replay(store::Id webhook, store::Id delivery, const store::Stamp& by) override;
  store::Result<std::uint64_t> replay_dead(store::Id webhook, std::int64_t since_ms, const store::Stamp& by) override;
  store::Result<store::Page<store::WebhookDelivery>> deliveries(store::Id webhook, const store::PageRequest& page,
                                                                const store::DeliveryFilter& filter) override;

 private:
  Database& database_;
};

}  // namespace dripfeed::sql
